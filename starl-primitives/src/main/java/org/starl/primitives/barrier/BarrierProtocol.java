package org.starl.primitives.barrier;

import static org.starl.time.Time.NS_PER_MS;

import java.util.Collections;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.barrier.BarrierMessage.Arrival;
import org.starl.primitives.barrier.BarrierMessage.Here;
import org.starl.primitives.suspicion.Suspicion;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/**
 * One robot's part in one barrier: generations 1, 2, 3, ... The Synod decides the outcome of each once,
 * from the outcomes before it. A waiting robot that sees the end of its generation, all members
 * arrived or some given up, proposes it.
 *
 * <p>Its effects go to a {@link SynodLink} and a {@link BarrierPort}.
 */
class BarrierProtocol extends SynodProtocol {

  /** Message delays from a proposal until other robots know the decision, plus one. */
  private static final int DECIDE = 6;

  private final ProcessId me;
  private final SortedSet<ProcessId> first;
  private final OutcomesFormat format;
  private final BarrierSettings settings;
  private final SynodLink link;
  private final BarrierPort port;
  private final Suspicion suspicion;

  // The latest decided generation; all before it are decided too.
  private long decided;
  private Outcomes outcomes = Outcomes.ALL_PASSED;

  // The arrivals in undecided generations: this one and later ones.
  private final TreeMap<Long, SortedSet<ProcessId>> arrivals = new TreeMap<>();

  private long generation = 1;
  private BarrierOutcome outcome = BarrierOutcome.NONE_YET;
  private boolean waiting;
  private boolean isLate;
  private final Set<ProcessId> noted = new TreeSet<>();

  // The members that this robot gives up in its proposal; empty unless it proposes or is about to.
  private SortedSet<ProcessId> givenUp = new TreeSet<>();

  private long sayAtNs = NEVER;
  private long proposeAtNs = NEVER;
  private long deadlineNs = NEVER;

  /**
   * @param first the members of generation 1, whose robots vote; the same on every robot, for ever
   */
  BarrierProtocol(
      ProcessId me,
      SortedSet<ProcessId> first,
      BarrierSettings settings,
      Rng rng,
      SynodLink link,
      BarrierPort port,
      long nowNs) {
    super(me.robot(), robots(first), me, settings.timing(), rng, link, nowNs);
    this.me = me;
    this.first = Collections.unmodifiableSortedSet(new TreeSet<>(first));
    this.format = new OutcomesFormat(first);
    this.settings = settings;
    this.link = link;
    this.port = port;
    this.suspicion = new Suspicion(settings.silenceMs() * NS_PER_MS);
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      decided(known.number(), format.read(known.value()));
    }
  }

  private static Participants robots(SortedSet<ProcessId> first) {
    return Participants.of(first.stream().map(ProcessId::robot).collect(Collectors.toList()));
  }

  // Calls and inputs.

  void arrive(long now) {
    nowNs = now;
    if (waiting) {
      throw new IllegalStateException("arrive while waiting in generation " + generation);
    }
    if (!members().contains(me)) {
      outcome = new BarrierOutcome.Excluded(outcomes.leftOutBy(me));
      return;
    }
    outcome = BarrierOutcome.NONE_YET;
    waiting = true;
    isLate = false;
    deadlineNs = now + settings.deadlineMs() * NS_PER_MS;
    if (decided >= generation) {
      tell();
      return;
    }
    arrivals(generation).add(me);
    for (ProcessId absent : absent()) {
      suspicion.expect(absent, now);
    }
    say();
    check();
  }

  void received(BarrierMessage message, long now) {
    nowNs = now;
    if (!first.contains(message.from())) {
      return;
    }
    suspicion.heard(message.from(), now);
    switch (message) {
      case Arrival m -> {
        answer(m);
        count(m.from(), m.generation());
      }
      case Here m -> {
        if (m.noted() == generation) {
          noted.add(m.from());
        }
        if (m.generation() <= decided) {
          tellOutcomes(m.from());
        } else if (m.hasArrived()) {
          count(m.from(), m.generation());
        }
      }
    }
    if (waiting) {
      check();
    }
  }

  @Override
  protected void ownTimers() {
    if (waiting && nowNs >= deadlineNs) {
      deadline();
    }
    if (waiting && nowNs >= sayAtNs) {
      say();
    }
    if (waiting) {
      check();
    }
  }

  @Override
  protected long ownWakeAtNs() {
    long ownNs = Math.min(deadlineNs, Math.min(proposeAtNs, sayAtNs));
    return waiting ? Math.min(ownNs, suspicion.wakeAtNs(nowNs)) : NEVER;
  }

  // Queries.

  @Override
  public @Nullable Wait waitsFor(Instance source) {
    SortedSet<ProcessId> absent = absent();
    if (!waiting || absent.isEmpty()) {
      return super.waitsFor(source);
    }
    return new Wait(
        source, "waits in generation " + generation + " for arrivals", ProcessId.robots(absent));
  }

  BarrierOutcome outcome() {
    return outcome;
  }

  long generation() {
    return generation;
  }

  boolean isWaiting() {
    return waiting;
  }

  ProcessId me() {
    return me;
  }

  /**
   * The state without times and the Synod's: robots with equal texts behave alike. Acknowledgements are
   * left out: they end repetitions alone.
   */
  String state() {
    SortedMap<Long, SortedSet<ProcessId>> here = new TreeMap<>(arrivals);
    here.values().removeIf(Set::isEmpty);
    String known = decided + " " + outcomes + here + generation;
    boolean isTurnSet = proposeAtNs != NEVER;
    return waiting
        ? known + isLate + suspicion.suspects(nowNs) + (isTurnSet ? "turn" : "") + givenUp
        : known;
  }

  // The protocol.

  /** {@code who} has arrived in {@code itsGeneration}. */
  void count(ProcessId who, long itsGeneration) {
    if (itsGeneration > decided) {
      arrivals(itsGeneration).add(who);
      if (itsGeneration == generation) {
        suspicion.release(who);
      }
    }
  }

  private void answer(Arrival m) {
    if (m.generation() <= decided) {
      tellOutcomes(m.from());
      return;
    }
    if (m.generation() > decided + 1) {
      // It knows outcomes that this robot does not know.
      synod.query(m.from().robot());
    }
    boolean hasArrived = arrivals(decided + 1).contains(me);
    port.send(m.from().robot(), new Here(me, decided + 1, hasArrived, m.generation()));
  }

  private void tellOutcomes(ProcessId to) {
    link.send(to.robot(), new SynodMessage.Decided(decided, format.toValue(outcomes)));
  }

  /** Works for the outcome of this generation, once it can be proposed. */
  void check() {
    if (!isAllHere()) {
      givenUp = absent();
      if (!isLate) {
        givenUp.retainAll(suspicion.suspects(nowNs));
      }
      if (givenUp.isEmpty()) {
        // The silent members are back.
        synod.stop();
        proposeAtNs = NEVER;
        return;
      }
    }
    if (synod.isProposing()) {
      return;
    }
    if (proposeAtNs == NEVER) {
      // In turns, since proposers defeat each other. The ones before may have crashed, so its own
      // turn comes before its deadline at the latest.
      long turnNs = DECIDE * settings.deltaMs() * NS_PER_MS;
      long rank = arrivals(generation).headSet(me).size();
      proposeAtNs = Math.max(nowNs, Math.min(nowNs + rank * turnNs, deadlineNs - turnNs));
    }
    if (nowNs >= proposeAtNs) {
      proposeAtNs = NEVER;
      synod.propose(generation, Value.EMPTY, wishes -> proposal(), nowNs);
    }
  }

  /** {@code Barrier_agreement.propose}: the proposal, from the latest knowledge. */
  private Value proposal() {
    return format.toValue(isAllHere() ? outcomes : outcomes.withBroken(generation, givenUp));
  }

  /** The first deadline gives up the absent members; the second one ends the wait. */
  void deadline() {
    if (isLate) {
      rest(new BarrierOutcome.Unknown(generation));
    } else {
      isLate = true;
      deadlineNs = nowNs + settings.deadlineMs() * NS_PER_MS;
    }
  }

  private void decided(long number, Outcomes upToIt) {
    decided = number;
    outcomes = upToIt;
    arrivals.headMap(number, true).clear();
    if (waiting) {
      tell();
    }
  }

  /** {@code Barrier_agreement.tell}: the outcome of the generation in which this robot waits. */
  private void tell() {
    if (!outcomes.isBroken(generation)) {
      next(new BarrierOutcome.Passed(generation));
    } else if (outcomes.missing(generation).contains(me)) {
      next(new BarrierOutcome.Excluded(generation));
    } else {
      next(new BarrierOutcome.Failed(generation, outcomes.missing(generation)));
    }
  }

  /** Ends the wait and the generation. */
  void next(BarrierOutcome told) {
    rest(told);
    generation++;
    noted.clear();
  }

  /** Ends the wait. */
  private void rest(BarrierOutcome told) {
    outcome = told;
    waiting = false;
    deadlineNs = NEVER;
    sayAtNs = NEVER;
    proposeAtNs = NEVER;
    synod.stop();
    suspicion.expected().forEach(suspicion::release);
  }

  /** Sends this robot's arrival to all members that have not arrived or have not acknowledged it. */
  private void say() {
    SortedSet<ProcessId> here = arrivals(generation);
    for (ProcessId member : members()) {
      if (!member.equals(me) && !(here.contains(member) && noted.contains(member))) {
        port.send(member.robot(), new Arrival(me, generation));
      }
    }
    sayAtNs = nowNs + settings.repeatMs() * NS_PER_MS;
  }

  private boolean isAllHere() {
    return arrivals(generation).containsAll(members());
  }

  private SortedSet<ProcessId> absent() {
    SortedSet<ProcessId> absent = members();
    absent.removeAll(arrivals(generation));
    return absent;
  }

  private SortedSet<ProcessId> members() {
    return outcomes.members(first, generation);
  }

  private SortedSet<ProcessId> arrivals(long itsGeneration) {
    return arrivals.computeIfAbsent(itsGeneration, g -> new TreeSet<>());
  }

  @Override
  public void chosen(long number, Value value) {
    for (ProcessId member : first) {
      if (!member.equals(me)) {
        link.send(member.robot(), new SynodMessage.Decided(number, value));
      }
    }
  }

  @Override
  public void learned(long number, Value value) {
    decided(number, format.read(value));
  }
}
