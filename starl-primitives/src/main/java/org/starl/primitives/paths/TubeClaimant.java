package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * The claims of one robot: sends its held and wanted tubes to all robots, and holds a wanted tube
 * when a majority has consented. Repeats the latest version to robots that have not answered. Pure
 * and clock-driven: {@link #timer} is due at {@link #wakeAtNs}.
 */
final class TubeClaimant {

  private final Participants participants;
  private final int needed;
  private final TubeSettings settings;
  private final Out out;
  private final Set<RobotId> votes = new TreeSet<>();
  private final Set<RobotId> refusals = new TreeSet<>();
  private Holding holding;
  private long wakeAtNs = Long.MAX_VALUE;
  private long resendNs;

  /** The effects of a claimant. */
  interface Out {

    /** Sends, best effort, also to this robot itself. */
    void send(RobotId to, TubeMessage message);

    /** The wanted tube is held now. */
    void granted(Tube tube);

    /** The request is withdrawn, because a majority cannot consent any more. */
    void refused();
  }

  /**
   * @param needed the consents that grant a claim: more than half of the participants
   * @param start the tubes held since before a restart; later versions have higher numbers
   */
  TubeClaimant(
      Participants participants, int needed, TubeSettings settings, Holding start, Out out) {
    this.participants = participants;
    this.needed = needed;
    this.settings = settings;
    this.holding = start;
    this.out = out;
  }

  Holding holding() {
    return holding;
  }

  boolean isAsking() {
    return !holding.wanted().isEmpty();
  }

  long wakeAtNs() {
    return wakeAtNs;
  }

  /** Requests {@code tube} in addition to the held ones. */
  void ask(Tube tube, long nowNs) {
    if (isAsking()) {
      throw new IllegalStateException("a request for " + holding.wanted() + " is open");
    }
    update(holding.held(), List.of(tube), nowNs);
  }

  /** Releases all but {@code rest}, which must be part of the held tubes. */
  void keep(List<Tube> rest, long nowNs) {
    update(rest, holding.wanted(), nowNs);
  }

  /** Cancels the request, if there is one. */
  void withdraw(long nowNs) {
    if (isAsking()) {
      update(holding.held(), List.of(), nowNs);
    }
  }

  void voted(RobotId from, long version, long nowNs) {
    if (version != holding.version() || !participants.contains(from)) {
      return;
    }
    refusals.remove(from);
    votes.add(from);
    if (isAsking() && votes.size() >= needed) {
      Tube tube = holding.wanted().get(0);
      List<Tube> held = new ArrayList<>(holding.held());
      held.add(tube);
      update(held, List.of(), nowNs);
      out.granted(tube);
    }
  }

  void refused(RobotId from, long version, long nowNs) {
    if (version != holding.version() || !isAsking() || votes.contains(from)) {
      return;
    }
    refusals.add(from);
    if (participants.size() - refusals.size() < needed) {
      withdraw(nowNs);
      out.refused();
    }
  }

  void timer(long nowNs) {
    if (nowNs < wakeAtNs) {
      return;
    }
    sendToUnanswered();
    resendNs = Math.min(resendNs + resendNs / 2, settings.maxResendNs());
    wakeAtNs = isAnswered() ? Long.MAX_VALUE : nowNs + resendNs;
  }

  /** All that decides what it holds and wants from now on; repetitions do not. */
  String state() {
    return isAsking() ? holding + " " + votes + refusals : holding.toString();
  }

  /** Whether an answer decides nothing, now and later. */
  boolean isSpent(RobotId from, long version) {
    return version < holding.version() || !isAsking() || votes.contains(from);
  }

  private void update(List<Tube> held, List<Tube> wanted, long nowNs) {
    holding = new Holding(holding.version() + 1, held, wanted);
    votes.clear();
    refusals.clear();
    resendNs = settings.resendNs();
    wakeAtNs = nowNs + resendNs;
    sendToUnanswered();
  }

  private void sendToUnanswered() {
    TubeMessage message = new TubeMessage.Ask(holding);
    for (RobotId robot : participants) {
      if (!votes.contains(robot) && !refusals.contains(robot)) {
        out.send(robot, message);
      }
    }
  }

  private boolean isAnswered() {
    return votes.size() + refusals.size() == participants.size();
  }
}
