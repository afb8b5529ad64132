package org.starl.primitives.agreement;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Sent;

/**
 * The rules of the Synod, on each message that a robot sends: a broken rule is seen long before two
 * robots decide differently. A restart changes nothing: what a robot said before, it must keep. It is
 * of all instances of all primitives that decide by the Synod.
 *
 * <ul>
 *   <li>{@code Ballots}: an acceptor answers no ballot below one that it has answered, and refuses only lower ones.
 *   <li>{@code Votes}: an acceptor's promise reports its latest vote.
 *   <li>{@code Quorums}: a ballot has one value, after promises of a majority, and their latest vote's
 *       if there is one; a value is reported as decided only after a majority has voted for it in one
 *       ballot.
 *   <li>{@code Answers}: an acceptor refuses a lower ballot in the step in which it is asked, and a robot that
 *       knows what is decided tells it to each robot that asks, and proposes for that number no more.
 *   <li>{@code Asks}: a ballot asks all acceptors in one step, for promises and then for votes, and none again
 *       that has answered.
 * </ul>
 *
 * <p>The last three are not checked of runs in real time: the end of a killed process's trace may be
 * missing, a step takes time, and that a storage is new is not in the trace.
 */
public final class SynodSpec extends LemmaMonitor {

  static final String BALLOTS = "synod.Ballots";
  static final String VOTES = "synod.Votes";
  static final String QUORUMS = "synod.Quorums";
  static final String ANSWERS = "synod.Answers";
  static final String ASKS = "synod.Asks";

  /** Not the ballots' own order, which could be wrong. */
  private static final Comparator<Ballot> ORDER =
      Comparator.comparingLong(Ballot::round).thenComparing(Ballot::proposer);

  /** Older numbers are forgotten: no robot is so far behind, and runs may be long. */
  private static final int KEPT_NUMBERS = 256;

  private final Map<Instance, Run> runs = new TreeMap<>();
  private final TellCheck tells = new TellCheck(ANSWERS);
  private final TellCheck asks = new TellCheck(ASKS);
  private boolean isRealTime;

  public SynodSpec() {
    lemma(
        BALLOTS,
        "An acceptor answers no ballot below one that it has answered, and refuses only lower ones.");
    lemma(VOTES, "An acceptor's promise reports its latest vote.");
    lemma(QUORUMS, "A value is proposed, and reported as decided, only as a majority allows.");
    lemma(
        ANSWERS,
        "A lower ballot is refused at once; who knows a decision tells it to those who ask, and asks no more.");
    lemma(
        ASKS,
        "A ballot asks all acceptors at once, for promises and then for votes; none again that has answered.");
    tells.begin();
    asks.begin();
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new SynodConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    tells.observe(event, report);
    asks.observe(event, report);
    switch (event) {
      case Sent sent when sent.message() instanceof SynodMessage message ->
          sent(sent, message, report);
      case Delivered got when !isRealTime && got.message() instanceof SynodMessage message ->
          heard(runs.computeIfAbsent(got.channel(), channel -> new Run()), got, message);
      case Fault fault when fault.name().equals(Fault.CRASH) -> ended(fault.robot());
      case Fault fault -> isRealTime |= fault.isRealTime();
      case Left left -> ended(left.robot());
      default -> {}
    }
  }

  private void ended(RobotId robot) {
    runs.values().forEach(run -> run.known.remove(robot));
  }

  private void heard(Run run, Delivered got, SynodMessage message) {
    long known = run.known.getOrDefault(got.robot(), 0L);
    switch (message) {
      // Some learners skip numbers, others keep what comes too early, and wait for those between.
      case Decided m when m.number() == known + 1 -> run.known.put(got.robot(), m.number());
      case Query m when known > m.number() -> mustAnswer(got, m.number() + 1, null);
      case Prepare m -> asked(run, got, m.number(), m.ballot(), known);
      case Accept m -> asked(run, got, m.number(), m.ballot(), known);
      case Promise m -> answered(run, got, m, new Question(m.ballot(), false));
      case Accepted m -> answered(run, got, m, new Question(m.ballot(), true));
      default -> {} // no rule
    }
  }

  private void answered(Run run, Delivered got, SynodMessage message, Question question) {
    if (!run.hasForgotten(message.number())) {
      decree(run, message)
          .answers
          .computeIfAbsent(question, any -> new TreeSet<>())
          .add(got.from().name());
    }
  }

  private void asked(Run run, Delivered got, long number, Ballot ballot, long known) {
    Decree decree = run.decrees.get(number);
    Ballot answered = decree == null ? null : decree.answered.get(got.robot());
    if (known >= number && run.acceptors.contains(got.robot().name())) {
      mustAnswer(got, number, null);
    } else if (answered != null && ORDER.compare(ballot, answered) < 0) {
      mustAnswer(got, number, ballot);
    }
  }

  /** It must refuse this ballot, or tell a decree of this number or a later one. */
  private void mustAnswer(Delivered got, long number, @Nullable Ballot refused) {
    tells.owes(
        got,
        got.from().name(),
        refused == null ? "what is decided, for number " + number : "no to ballot " + refused,
        told ->
            (told instanceof Decided m && m.number() >= number)
                || (told instanceof Nack no
                    && no.number() == number
                    && no.ballot().equals(refused)));
  }

  private void sent(Sent sent, SynodMessage message, Report report) {
    Run run = runs.computeIfAbsent(sent.channel(), channel -> new Run());
    long known = run.known.getOrDefault(sent.robot(), 0L);
    if (!isRealTime && (message instanceof Prepare || message instanceof Accept)) {
      report.checked(ANSWERS);
      if (message.number() <= known) {
        String detail = sent.channel() + ": " + message + " after it has heard decree " + known;
        report.violated(ANSWERS, sent.timeNs(), List.of(sent.robot()), detail);
      }
    }
    if (message instanceof Decided) {
      run.known.merge(sent.robot(), message.number(), Math::max);
    }
    if (run.hasForgotten(message.number())) {
      return;
    }
    switch (message) {
      case Prepare m -> {
        run.acceptors.add(sent.to());
        asked(run, sent, m, report);
      }
      case Promise m -> decree(run, m).promised(sent, m, report);
      case Accepted m -> decree(run, m).voted(sent, m.ballot(), report);
      case Accept m -> {
        decree(run, m).proposed(sent, m, report);
        asked(run, sent, m, report);
      }
      case Decided m -> decree(run, m).decided(sent, m.value(), report);
      case Nack m -> {
        boolean isLower = ORDER.compare(m.ballot(), m.promised()) < 0;
        decree(run, m).check(BALLOTS, isLower, sent, () -> "is no lower ballot", report);
      }
      case Query m -> {} // no rule
    }
  }

  /** The first question of a ballot's phase goes to all acceptors. */
  private void asked(Run run, Sent sent, SynodMessage message, Report report) {
    if (isRealTime) {
      return;
    }
    Question question = Objects.requireNonNull(Question.of(message));
    Decree decree = decree(run, message);
    boolean isAnswered = decree.answers.getOrDefault(question, Set.of()).contains(sent.to());
    decree.check(ASKS, !isAnswered, sent, () -> "to one that has answered", report);
    if (decree.questions.add(question)) {
      for (String acceptor : run.acceptors) {
        asks.owes(sent, acceptor, question.toString(), told -> question.equals(Question.of(told)));
      }
    }
  }

  private static Ballot higher(Ballot a, Ballot b) {
    return ORDER.compare(a, b) > 0 ? a : b;
  }

  private Decree decree(Run run, SynodMessage message) {
    Decree decree = run.decrees.computeIfAbsent(message.number(), n -> new Decree(run));
    if (run.decrees.size() > KEPT_NUMBERS) {
      run.decrees.pollFirstEntry();
    }
    return decree;
  }

  /** What a ballot asks all acceptors in one of its phases. */
  private record Question(Ballot ballot, boolean isForVotes) {

    /** Null for a message that is no question. */
    static @Nullable Question of(Object message) {
      return switch (message) {
        case Prepare m -> new Question(m.ballot(), false);
        case Accept m -> new Question(m.ballot(), true);
        default -> null;
      };
    }
  }

  /** One channel. */
  private static final class Run {
    private final Set<String> acceptors = new TreeSet<>();
    private final TreeMap<Long, Decree> decrees = new TreeMap<>();
    // The latest decree that the robot's present program is seen to know.
    private final Map<RobotId, Long> known = new TreeMap<>();

    boolean hasForgotten(long number) {
      return decrees.size() >= KEPT_NUMBERS && number < decrees.firstKey();
    }

    boolean isMajority(long count) {
      return 2 * count > acceptors.size();
    }
  }

  /** What robots have said for one number. */
  private final class Decree {
    private final Run run;
    private final Map<RobotId, Ballot> answered = new TreeMap<>();
    private final Map<RobotId, Ballot> voted = new TreeMap<>();
    private final Map<Ballot, Attempt> attempts = new TreeMap<>(ORDER);
    private final Set<Question> questions = new LinkedHashSet<>();
    // The acceptors whose answer has reached the robot that asks.
    private final Map<Question, Set<String>> answers = new LinkedHashMap<>();

    Decree(Run run) {
      this.run = run;
    }

    void promised(Sent sent, Promise promise, Report report) {
      answers(sent, promise.ballot(), report);
      Vote told = promise.vote();
      Ballot last = voted.get(sent.robot());
      boolean isLate = last != null && (told == null || ORDER.compare(told.ballot(), last) < 0);
      check(VOTES, !isLate, sent, () -> "after its vote in ballot " + last, report);
      if (told != null) {
        Value value = attempt(told.ballot()).value;
        boolean isKnown = value == null || value.equals(told.value());
        check(
            VOTES,
            isKnown,
            sent,
            () -> "but ballot " + told.ballot() + " has the value " + value,
            report);
      }
      attempt(promise.ballot()).promised(sent.robot(), told);
    }

    void voted(Sent sent, Ballot ballot, Report report) {
      answers(sent, ballot, report);
      voted.merge(sent.robot(), ballot, SynodSpec::higher);
      attempt(ballot).votes.add(sent.robot());
    }

    void proposed(Sent sent, Accept accept, Report report) {
      Attempt attempt = attempt(accept.ballot());
      Value value = accept.value();
      Value before = attempt.value;
      if (before == null) {
        boolean isOwn = accept.ballot().proposer().robot().equals(sent.robot());
        check(QUORUMS, isOwn, sent, () -> "in another robot's ballot", report);
        if (!isRealTime) {
          boolean isSafe = attempt.allows(value, run);
          check(QUORUMS, isSafe, sent, () -> "after the promises " + attempt.promises, report);
        }
        attempt.value = value;
      }
      boolean isOne = before == null || value.equals(before);
      check(QUORUMS, isOne, sent, () -> "after " + before + " in this ballot", report);
    }

    void decided(Sent sent, Value value, Report report) {
      if (isRealTime) {
        return;
      }
      boolean isChosen = false;
      for (Attempt attempt : attempts.values()) {
        Value its = attempt.value;
        isChosen |= its != null && value.equals(its) && run.isMajority(attempt.votes.size());
      }
      check(QUORUMS, isChosen, sent, () -> "without the votes of a majority", report);
    }

    private void answers(Sent sent, Ballot ballot, Report report) {
      Ballot highest = answered.merge(sent.robot(), ballot, SynodSpec::higher);
      check(
          BALLOTS,
          ballot.equals(highest),
          sent,
          () -> "after an answer to ballot " + highest,
          report);
    }

    private Attempt attempt(Ballot ballot) {
      return attempts.computeIfAbsent(ballot, b -> new Attempt());
    }

    private void check(
        String lemma, boolean holds, Sent sent, Supplier<String> wrong, Report report) {
      report.checked(lemma);
      if (!holds) {
        String detail = sent.channel() + ": " + sent.message() + " " + wrong.get();
        report.violated(lemma, sent.timeNs(), List.of(sent.robot()), detail);
      }
    }
  }

  /** One ballot: the votes that its promises report, its value, and its voters. */
  private static final class Attempt {
    private final Map<RobotId, @Nullable Vote> promises = new TreeMap<>();
    private final Set<RobotId> votes = new TreeSet<>();
    private @Nullable Value value;

    /** A repeated promise may report a later vote; the first one counts. */
    void promised(RobotId acceptor, @Nullable Vote vote) {
      if (!promises.containsKey(acceptor)) {
        promises.put(acceptor, vote);
      }
    }

    /** Whether some majority's promises allow the value. */
    boolean allows(Value proposed, Run run) {
      boolean isFree = run.isMajority(upTo(null));
      for (Vote vote : promises.values()) {
        isFree |=
            vote != null && proposed.equals(vote.value()) && run.isMajority(upTo(vote.ballot()));
      }
      return isFree;
    }

    /** The promises that report no vote in a higher ballot; null is below all. */
    private long upTo(@Nullable Ballot highest) {
      long count = 0;
      for (Vote vote : promises.values()) {
        boolean isUpTo =
            vote == null || (highest != null && ORDER.compare(vote.ballot(), highest) <= 0);
        count += isUpTo ? 1 : 0;
      }
      return count;
    }
  }
}
