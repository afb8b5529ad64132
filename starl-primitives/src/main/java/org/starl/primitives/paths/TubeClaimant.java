package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * One robot's claims: tells everybody what it holds and wants, version by version, and holds what a
 * majority has consented to. Repeats its latest word to whoever has not answered it. Pure and
 * clock-driven: {@link #timer} is due at {@link #wakeAtNs}.
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

  /** Where a claimant's effects go. */
  interface Out {

    /** Sends, best effort; to this robot itself as well. */
    void send(RobotId to, TubeMessage message);

    /** What it wanted is its own. */
    void granted(Tube tube);

    /** What it wanted will not be its own: a majority cannot consent any more. It wants it no more. */
    void refused();
  }

  /**
   * @param needed how many consents make a claim: more than half of the participants
   * @param start what it holds, from before a restart; versions go on above its version
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

  /** Asks for {@code tube} beside what it holds. */
  void ask(Tube tube, long nowNs) {
    if (isAsking()) {
      throw new IllegalStateException("asks for " + holding.wanted() + " already");
    }
    say(holding.held(), List.of(tube), nowNs);
  }

  /** Holds no more than {@code rest}, which is part of what it holds. */
  void keep(List<Tube> rest, long nowNs) {
    say(rest, holding.wanted(), nowNs);
  }

  /** Wants nothing any more. */
  void withdraw(long nowNs) {
    if (isAsking()) {
      say(holding.held(), List.of(), nowNs);
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
      say(held, List.of(), nowNs);
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
    tell();
    resendNs = Math.min(resendNs + resendNs / 2, settings.maxResendNs());
    wakeAtNs = isAnswered() ? Long.MAX_VALUE : nowNs + resendNs;
  }

  private void say(List<Tube> held, List<Tube> wanted, long nowNs) {
    holding = new Holding(holding.version() + 1, held, wanted);
    votes.clear();
    refusals.clear();
    resendNs = settings.resendNs();
    wakeAtNs = nowNs + resendNs;
    tell();
  }

  private void tell() {
    TubeMessage word = new TubeMessage.Ask(holding);
    for (RobotId robot : participants) {
      if (!votes.contains(robot) && !refusals.contains(robot)) {
        out.send(robot, word);
      }
    }
  }

  private boolean isAnswered() {
    return votes.size() + refusals.size() == participants.size();
  }
}
