package org.starl.primitives.election;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.primitives.suspicion.Suspicion;
import org.starl.random.Rng;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;

/**
 * One robot's part in one election: terms 1, 2, 3, ... each decided by the Synod. The strategy only
 * chooses the candidate to propose, and when.
 *
 * <p>Its effects go to a {@link SynodLink} and an {@link ElectionPort}.
 */
class ElectionProtocol extends SynodProtocol {

  private final ProcessId me;
  private final Participants participants;
  private final ElectionSettings settings;
  private final Rng rng;
  private final ElectionPort port;
  private final Suspicion suspicion;

  // The highest incarnation heard of each robot. Lower ones are dead.
  private final TreeMap<RobotId, Long> newest = new TreeMap<>();

  private boolean takesPart;
  private long term;
  private Leader leader = Leader.NONE;

  // The candidates of the present term; null if this robot is none.
  private @Nullable Candidates poll;
  private long draw;

  private long planAtNs = NEVER;
  private long sayAtNs = NEVER;
  private long deadlineNs = NEVER;

  /**
   * @param participants the robots that may be elected, and that vote; the same on every robot, for
   *     ever
   */
  ElectionProtocol(
      ProcessId me,
      Participants participants,
      ElectionSettings settings,
      Rng rng,
      SynodLink link,
      ElectionPort port,
      long nowNs) {
    super(me.robot(), participants, me, settings.timing(), rng.fork("synod"), link, nowNs);
    this.me = me;
    this.participants = participants;
    this.settings = settings;
    this.rng = rng;
    this.port = port;
    this.suspicion = new Suspicion(settings.silenceMs() * NS_PER_MS);
    this.newest.put(me.robot(), me.inc());
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      decided(known.number(), fromValue(known.value()));
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
      // The same term: a new one would end the election of the robots that have not failed yet.
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
      newIncarnation(from, message.from().inc());
    }
    suspicion.heard(message.from(), now);
    switch (message) {
      case Candidacy m -> candidacy(m);
      case Elected m -> elected(m);
    }
  }

  @Override
  public @Nullable Wait waitsFor(Instance source) {
    if (leader instanceof Leader.Fail) {
      return new Wait(source, "failed in term " + term + ": no majority answered", List.of());
    }
    Wait synodWait = super.waitsFor(source);
    return synodWait != null || !takesPart || leader != Leader.NONE
        ? synodWait
        : new Wait(source, "no leader yet in term " + term, List.of());
  }

  @Override
  protected void ownTimers() {
    if (nowNs >= deadlineNs) {
      fail();
    }
    if (takesPart && leader instanceof Leader.Name name && isSuspected(name.id())) {
      start(term + 1);
    }
    if (nowNs >= sayAtNs) {
      say();
    }
    if (nowNs >= planAtNs) {
      plan();
    }
  }

  @Override
  protected long ownWakeAtNs() {
    long ownNs = Math.min(deadlineNs, Math.min(planAtNs, sayAtNs));
    return Math.min(ownNs, suspicion.wakeAtNs(nowNs));
  }

  // Queries.

  Leader leader() {
    return leader;
  }

  long term() {
    return term;
  }

  ProcessId me() {
    return me;
  }

  /** The candidates that a strategy may propose now. */
  SortedSet<ProcessId> choices() {
    Candidates open = openPoll();
    return new TreeSet<>(open == null ? List.of() : open.byDraw(Long.MIN_VALUE));
  }

  /** The state without times, draws and the Synod's: robots with equal texts behave alike. */
  String state() {
    String known = term + " " + leader + newest + takesPart;
    return poll == null ? known : known + new TreeSet<>(poll.byDraw(Long.MIN_VALUE));
  }

  // The protocol.

  /** {@code Election_agreement.candidate}: stands in {@code next}, with no leader yet. */
  private void start(long next) {
    if (leader instanceof Leader.Name name) {
      suspicion.release(name.id());
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
    poll = new Candidates(me, draw, nowNs, settings.deltaMs() * NS_PER_MS);
    if (deadlineNs == NEVER) {
      // For the app, successive terms without a leader are one wait.
      deadlineNs = nowNs + settings.deadlineMs() * NS_PER_MS;
    }
    say();
    plan();
  }

  private void candidacy(Candidacy m) {
    if (m.term() > term && takesPart) {
      start(m.term());
    }
    Candidates open = poll;
    if (m.term() != term || leader.isElected()) {
      answer(m);
    } else if (open != null && open.heard(m.from(), m.draw(), nowNs)) {
      port.send(m.from().robot(), myCandidacy());
    }
  }

  /** Learns what another robot knows, if it is of this term or a later one. */
  void elected(Elected m) {
    if (m.term() < term) {
      answer(m);
    } else {
      synod.learn(m.term(), toValue(m.leader()));
    }
  }

  /** Tells a robot that is behind what this robot knows; one that is ahead needs nothing. */
  private void answer(ElectionMessage m) {
    if (m.term() <= term) {
      if (leader instanceof Leader.Name name) {
        port.send(m.from().robot(), new Elected(me, name.term(), name.id()));
      } else if (poll != null) {
        port.send(m.from().robot(), myCandidacy());
      }
    }
  }

  /** Asks the strategy, until it proposes a candidate. */
  private void plan() {
    planAtNs = NEVER;
    Candidates open = openPoll();
    if (open != null) {
      switch (settings.strategy().plan(open, nowNs)) {
        case ElectionStrategy.Propose plan -> propose(plan.candidate());
        case ElectionStrategy.Wait plan -> planAtNs = plan.untilNs();
      }
    }
  }

  /** The candidates, while this robot is to propose one. */
  private @Nullable Candidates openPoll() {
    return leader instanceof Leader.None && !synod.isProposing() ? poll : null;
  }

  /** {@code Election_agreement.propose}. */
  void propose(ProcessId candidate) {
    Value value = toValue(candidate);
    synod.propose(term, Value.EMPTY, wishes -> value, nowNs);
  }

  /** {@code Election_agreement.learn}. */
  void decided(long itsTerm, ProcessId itsLeader) {
    if (itsTerm < term || (itsTerm == term && leader.isElected())) {
      return;
    }
    if (leader instanceof Leader.Name name) {
      suspicion.release(name.id());
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
      suspicion.expect(itsLeader, nowNs);
      if (isSuspected(itsLeader)) {
        start(term + 1);
      }
    }
  }

  private boolean isSuspected(ProcessId id) {
    return newest.getOrDefault(id.robot(), 0L) > id.inc() || suspicion.suspects(id, nowNs);
  }

  /** A robot is back with a higher incarnation: the one before is dead. */
  private void newIncarnation(RobotId robot, long inc) {
    Long before = newest.put(robot, inc);
    if (before != null && poll != null) {
      poll.strike(new ProcessId(robot, before));
    }
    if (takesPart && leader instanceof Leader.Name name && isSuspected(name.id())) {
      start(term + 1);
    }
  }

  /** Broadcasts this robot's leadership or candidacy, and sets the timer to repeat it. */
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

  /** A leader as the Synod's value. */
  static Value toValue(ProcessId leader) {
    return Value.write(out -> Shapes.PROCESS.write(leader, out));
  }

  private static ProcessId fromValue(Value value) {
    return value.read("a leader", Shapes.PROCESS::read);
  }

  @Override
  public void chosen(long number, Value value) {
    port.broadcast(new Elected(me, number, fromValue(value)));
  }

  @Override
  public void learned(long number, Value value) {
    decided(number, fromValue(value));
  }
}
