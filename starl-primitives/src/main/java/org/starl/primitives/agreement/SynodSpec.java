package org.starl.primitives.agreement;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.MessageText;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * The rules of the Synod, on each message that a robot sends: a broken rule is seen long before two
 * robots decide differently. A restart changes nothing: what a robot said before, it must keep. It is
 * of all instances of all primitives that decide by the Synod.
 *
 * <ul>
 *   <li>{@code Ballots}: an acceptor answers no ballot below one that it has answered.
 *   <li>{@code Votes}: an acceptor's promise reports its latest vote.
 *   <li>{@code Quorums}: a ballot has one value, after promises of a majority, and their latest vote's
 *       if there is one; a value is reported as decided only after a majority has voted for it in one
 *       ballot.
 * </ul>
 *
 * <p>The last one is not checked of runs in real time: the end of a killed process's trace may be
 * missing.
 */
public final class SynodSpec extends LemmaMonitor {

  static final String BALLOTS = "Ballots";
  static final String VOTES = "Votes";
  static final String QUORUMS = "Quorums";

  /** Older numbers are forgotten: no robot is so far behind, and runs may be long. */
  private static final int KEPT_NUMBERS = 256;

  private static final List<String> RULED =
      List.of("Prepare", "Promise", "Accept", "Accepted", "Decided");

  private final String channels;
  private final Map<String, Instance> instances = new TreeMap<>();
  private boolean isRealTime;

  /**
   * @param primitive whose channels carry messages of a Synod, such as {@code registration}
   */
  public SynodSpec(String primitive) {
    channels = primitive + "/";
    lemma(BALLOTS, "An acceptor answers no ballot below one that it has answered.");
    lemma(VOTES, "An acceptor's promise reports its latest vote.");
    lemma(QUORUMS, "A value is proposed, and reported as decided, only as a majority allows.");
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof Sent sent) {
      sent(sent, report);
    } else if (event instanceof Fault fault) {
      isRealTime |= fault.isRealTime();
    }
  }

  private void sent(Sent sent, Report report) {
    String message = sent.message();
    if (!sent.channel().startsWith(channels)) {
      return; // An app may have messages of these names.
    }
    String type = MessageText.type(message);
    if (!RULED.contains(type) || isForgotten(sent)) {
      return;
    }
    switch (type) {
      // The first question of a ballot goes to all acceptors.
      case "Prepare" -> instance(sent).acceptors.add(sent.to());
      case "Promise" -> decree(sent).promised(sent, field(message, "vote"), report);
      case "Accepted" -> decree(sent).voted(sent, report);
      case "Accept" -> decree(sent).proposed(sent, report);
      case "Decided" -> decree(sent).decided(sent, report);
      default -> throw new IllegalStateException(type + ": no rule");
    }
  }

  private boolean isForgotten(Sent sent) {
    TreeMap<Long, Decree> decrees = instance(sent).decrees;
    return decrees.size() >= KEPT_NUMBERS && number(sent) < decrees.firstKey();
  }

  private static long number(Sent sent) {
    return Long.parseLong(field(sent.message(), "number"));
  }

  private static String field(String message, String name) {
    return MessageText.field(message, name);
  }

  private static Ballot higher(Ballot a, Ballot b) {
    return a.compareTo(b) > 0 ? a : b;
  }

  private Instance instance(Sent sent) {
    return instances.computeIfAbsent(sent.channel(), channel -> new Instance());
  }

  private Decree decree(Sent sent) {
    Instance instance = instance(sent);
    Decree decree = instance.decrees.computeIfAbsent(number(sent), n -> new Decree(instance));
    if (instance.decrees.size() > KEPT_NUMBERS) {
      instance.decrees.pollFirstEntry();
    }
    return decree;
  }

  private static final class Instance {
    private final Set<String> acceptors = new TreeSet<>();
    private final TreeMap<Long, Decree> decrees = new TreeMap<>();

    boolean isMajority(long count) {
      return 2 * count > acceptors.size();
    }
  }

  /** What robots have said for one number. */
  private final class Decree {
    private final Instance instance;
    private final Map<String, Ballot> answered = new TreeMap<>();
    private final Map<String, Ballot> voted = new TreeMap<>();
    private final Map<Ballot, Attempt> attempts = new TreeMap<>();

    Decree(Instance instance) {
      this.instance = instance;
    }

    void promised(Sent sent, String vote, Report report) {
      Ballot ballot = answer(sent, report);
      Ballot last = voted.get(sent.robot().name());
      Ballot told = Attempt.ballot(vote);
      boolean isLate = last != null && (told == null || told.compareTo(last) < 0);
      check(VOTES, !isLate, sent, "after its vote in ballot " + last, report);
      if (told != null) {
        String value = attempt(told).value;
        boolean isKnown = value == null || value.equals(field(vote, "value"));
        check(VOTES, isKnown, sent, "but ballot " + told + " has the value " + value, report);
      }
      attempt(ballot).promises.putIfAbsent(sent.robot().name(), vote);
    }

    void voted(Sent sent, Report report) {
      Ballot ballot = answer(sent, report);
      voted.merge(sent.robot().name(), ballot, SynodSpec::higher);
      attempt(ballot).votes.add(sent.robot().name());
    }

    void proposed(Sent sent, Report report) {
      Ballot ballot = Ballot.parse(field(sent.message(), "ballot"));
      Attempt attempt = attempt(ballot);
      String value = field(sent.message(), "value");
      if (attempt.value == null) {
        boolean isOwn = ballot.proposer().robot().equals(sent.robot());
        check(QUORUMS, isOwn, sent, "in another robot's ballot", report);
        boolean isSafe = isRealTime || attempt.allows(value, instance);
        check(QUORUMS, isSafe, sent, "after the promises " + attempt.promises, report);
        attempt.value = value;
      }
      boolean isOne = value.equals(attempt.value);
      check(QUORUMS, isOne, sent, "after " + attempt.value + " in this ballot", report);
    }

    void decided(Sent sent, Report report) {
      String value = field(sent.message(), "value");
      boolean isChosen = isRealTime;
      for (Attempt attempt : attempts.values()) {
        isChosen |= value.equals(attempt.value) && instance.isMajority(attempt.votes.size());
      }
      check(QUORUMS, isChosen, sent, "without the votes of a majority", report);
    }

    private Ballot answer(Sent sent, Report report) {
      Ballot ballot = Ballot.parse(field(sent.message(), "ballot"));
      Ballot highest = answered.merge(sent.robot().name(), ballot, SynodSpec::higher);
      check(BALLOTS, highest.equals(ballot), sent, "after an answer to ballot " + highest, report);
      return ballot;
    }

    private Attempt attempt(Ballot ballot) {
      return attempts.computeIfAbsent(ballot, b -> new Attempt());
    }

    private void check(String lemma, boolean holds, Sent sent, String wrong, Report report) {
      report.checked(lemma);
      if (!holds) {
        String detail = sent.channel() + ": " + sent.message() + " " + wrong;
        report.violated(lemma, sent.timeNs(), List.of(sent.robot()), detail);
      }
    }
  }

  /** One ballot: the votes that its promises report, its value, and its voters. */
  private static final class Attempt {
    private final Map<String, String> promises = new TreeMap<>();
    private final Set<String> votes = new TreeSet<>();
    private @Nullable String value;

    /** Whether some majority's promises allow the value. */
    boolean allows(String proposed, Instance instance) {
      boolean isFree = instance.isMajority(upTo(null));
      for (String vote : promises.values()) {
        isFree |=
            !vote.equals("null")
                && proposed.equals(field(vote, "value"))
                && instance.isMajority(upTo(ballot(vote)));
      }
      return isFree;
    }

    /** The promises that report no vote in a higher ballot; null is below all. */
    private long upTo(@Nullable Ballot highest) {
      long count = 0;
      for (String vote : promises.values()) {
        Ballot ballot = ballot(vote);
        count += ballot == null || (highest != null && ballot.compareTo(highest) <= 0) ? 1 : 0;
      }
      return count;
    }

    static @Nullable Ballot ballot(String vote) {
      return vote.equals("null") ? null : Ballot.parse(field(vote, "ballot"));
    }
  }
}
