package org.starl.primitives.election;

import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Synod;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodListener;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.primitives.suspicion.Suspicion;
import org.starl.random.Rng;

/**
 * One robot's part in one election: terms 1, 2, 3, ... each decided by the Synod. The strategy says
 * whom to propose and when, and nothing else.
 *
 * <p>Calls, messages and timers in, effects out through a {@link SynodLink} and an {@link ElectionPort}.
 */
class ElectionProtocol implements SynodProtocol {

  private static final long NS_PER_MS = 1_000_000;
  private static final long NEVER = Long.MAX_VALUE;

  private final ProcessId me;
  private final Participants participants;
  private final ElectionSettings settings;
  private final Rng rng;
  private final ElectionPort port;
  private final Synod synod;
  private final Suspicion suspicion;

  // The highest incarnation heard of each robot: lower ones are dead.
  private final TreeMap<RobotId, Long> newest = new TreeMap<>();

  private boolean takesPart;
  private long term;
  private Leader leader = Leader.NONE;

  // Of the present term, where this robot stands in it.
  private @Nullable Poll poll;
  private long draw;

  private long planAtNs = NEVER;
  private long sayAtNs = NEVER;
  private long deadlineNs = NEVER;
  private long nowNs;

  /**
   * @param participants who may be elected, and who votes; the same on every robot, for ever
   */
  ElectionProtocol(
      ProcessId me,
      Participants participants,
      ElectionSettings settings,
      Rng rng,
      SynodLink link,
      ElectionPort port,
      long nowNs) {
    this.me = me;
    this.participants = participants;
    this.settings = settings;
    this.rng = rng;
    this.port = port;
    this.nowNs = nowNs;
    this.suspicion = new Suspicion(settings.silenceMs() * NS_PER_MS);
    this.newest.put(me.robot(), me.inc());
    this.synod =
        new Synod(
            me.robot(),
            participants,
            me,
            settings.timing(),
            rng.fork("synod"),
            link,
            new Decrees());
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      decided(known.number(), ElectionCodec.leader(known.value()));
    }
  }

  // Calls and inputs.

  void do_election(long now) {
    nowNs = now;
    if (!participants.contains(me.robot())) {
      throw new IllegalStateException(
          "do_election among " + participants + ": expected " + me.robot() + " among them");
    }
    takesPart = true;
    if (leader instanceof Leader.Name name) {
      watch(name.id());
    } else if (poll == null) {
      start(term + 1);
    } else if (leader instanceof Leader.Fail) {
      // The same term: a higher one would end the efforts of those who have not failed yet.
      stand();
    }
  }

  void received(ElectionMessage message, long now) {
    nowNs = now;
    RobotId from = message.from().robot();
    long newestInc = newest.getOrDefault(from, 0L);
    if (!participants.contains(from) || message.from().inc() < newestInc) {
      return;
    }
    if (message.from().inc() > newestInc) {
      bury(from, message.from().inc());
    }
    suspicion.heard(message.from(), now);
    switch (message) {
      case Candidacy m -> candidacy(m);
      case Elected m -> elected(m);
    }
  }

  @Override
  public void received(RobotId from, SynodMessage message, long now) {
    nowNs = now;
    synod.received(from, message, now);
  }

  @Override
  public void flushed(long version, long now) {
    nowNs = now;
    synod.flushed(version);
  }

  @Override
  public void timer(long now) {
    nowNs = now;
    synod.timer(now);
    if (now >= deadlineNs) {
      fail();
    }
    if (takesPart && leader instanceof Leader.Name name && isSuspected(name.id())) {
      start(term + 1);
    }
    if (now >= sayAtNs) {
      say();
    }
    if (now >= planAtNs) {
      plan();
    }
  }

  @Override
  public long wakeAtNs() {
    long ownNs = Math.min(deadlineNs, Math.min(planAtNs, sayAtNs));
    return Math.min(synod.wakeAtNs(), Math.min(ownNs, suspicion.wakeAtNs(nowNs)));
  }

  // What is known.

  Leader leader() {
    return leader;
  }

  long term() {
    return term;
  }

  ProcessId me() {
    return me;
  }

  // The protocol.

  /** {@code Election_agreement.candidate}: stands in {@code next}, with no leader yet. */
  private void start(long next) {
    if (leader instanceof Leader.Name name) {
      suspicion.releases(name.id());
    }
    term = next;
    draw = rng.nextLong();
    port.candidate(next);
    stand();
  }

  /** Begins to work for the decision of the present term. */
  private void stand() {
    leader = Leader.NONE;
    synod.stop();
    poll = new Poll(me, draw, nowNs, settings.deltaMs() * NS_PER_MS);
    if (deadlineNs == NEVER) {
      // Terms that follow each other without a leader are one wait for the app.
      deadlineNs = nowNs + settings.deadlineMs() * NS_PER_MS;
    }
    say();
    plan();
  }

  private void candidacy(Candidacy m) {
    if (m.term() > term && takesPart) {
      start(m.term());
    }
    Poll open = poll;
    if (m.term() != term || leader.isElected()) {
      answer(m);
    } else if (open != null && open.heard(m.from(), m.draw(), nowNs)) {
      port.send(m.from().robot(), myCandidacy());
    }
  }

  /** What another robot has learned: of this term or a later one, it is learned here as well. */
  void elected(Elected m) {
    if (m.term() < term) {
      answer(m);
    } else {
      synod.learn(m.term(), ElectionCodec.value(m.leader()));
    }
  }

  /** Whoever is behind hears what this robot knows; whoever is ahead has no use for it. */
  private void answer(ElectionMessage m) {
    if (m.term() <= term) {
      if (leader instanceof Leader.Name name) {
        port.send(m.from().robot(), new Elected(me, name.term(), name.id()));
      } else if (poll != null) {
        port.send(m.from().robot(), myCandidacy());
      }
    }
  }

  /** Asks the strategy, until it has proposed somebody. */
  private void plan() {
    planAtNs = NEVER;
    Poll open = poll;
    if (open != null && leader instanceof Leader.None && !synod.isProposing()) {
      switch (settings.strategy().plan(open, nowNs)) {
        case ElectionStrategy.Propose plan -> propose(plan.candidate());
        case ElectionStrategy.Wait plan -> planAtNs = plan.untilNs();
      }
    }
  }

  /** {@code Election_agreement.propose}. */
  void propose(ProcessId candidate) {
    Value value = ElectionCodec.value(candidate);
    synod.propose(term, Value.EMPTY, wishes -> value, nowNs);
  }

  /** {@code Election_agreement.learn}. */
  void decided(long itsTerm, ProcessId itsLeader) {
    if (itsTerm < term || (itsTerm == term && leader.isElected())) {
      return;
    }
    if (leader instanceof Leader.Name name) {
      suspicion.releases(name.id());
    }
    term = itsTerm;
    leader = new Leader.Name(itsLeader, itsTerm);
    poll = null;
    planAtNs = NEVER;
    sayAtNs = NEVER;
    if (itsLeader.equals(me)) {
      say();
    } else if (takesPart) {
      watch(itsLeader);
    }
    if (leader.isElected()) {
      deadlineNs = NEVER;
    }
  }

  private void fail() {
    deadlineNs = NEVER;
    planAtNs = NEVER;
    sayAtNs = NEVER;
    leader = Leader.FAIL;
    synod.stop();
  }

  private void watch(ProcessId itsLeader) {
    if (!itsLeader.equals(me)) {
      suspicion.expects(itsLeader, nowNs);
      if (isSuspected(itsLeader)) {
        start(term + 1);
      }
    }
  }

  private boolean isSuspected(ProcessId id) {
    return newest.getOrDefault(id.robot(), 0L) > id.inc() || suspicion.suspects(id, nowNs);
  }

  /** A robot is back as another one: who it was is dead. */
  private void bury(RobotId robot, long inc) {
    Long before = newest.put(robot, inc);
    if (before != null && poll != null) {
      poll.strike(new ProcessId(robot, before));
    }
    if (takesPart && leader instanceof Leader.Name name && isSuspected(name.id())) {
      start(term + 1);
    }
  }

  /** Tells everybody what this robot stands for, and does so again after a while. */
  private void say() {
    if (leader instanceof Leader.Name name && name.id().equals(me)) {
      port.broadcast(new Elected(me, term, me));
      sayAtNs = nowNs + settings.heartbeatMs() * NS_PER_MS;
    } else if (leader instanceof Leader.None && poll != null) {
      port.broadcast(myCandidacy());
      sayAtNs = nowNs + settings.deltaMs() * NS_PER_MS;
    } else {
      sayAtNs = NEVER;
    }
  }

  private Candidacy myCandidacy() {
    return new Candidacy(me, term, draw);
  }

  private final class Decrees implements SynodListener {
    @Override
    public void chosen(long number, Value value) {
      port.broadcast(new Elected(me, number, ElectionCodec.leader(value)));
    }

    @Override
    public void learned(long number, Value value) {
      decided(number, ElectionCodec.leader(value));
    }
  }
}
