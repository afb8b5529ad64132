package org.starl.primitives.barrier;

import java.util.Collections;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Synod;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodListener;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.barrier.BarrierMessage.Arrival;
import org.starl.primitives.barrier.BarrierMessage.Here;
import org.starl.primitives.suspicion.Suspicion;
import org.starl.random.Rng;

/**
 * One robot's part in one barrier: generations 1, 2, 3, ... the outcome of each decided once by the
 * Synod, from what the outcome before it was. Whoever waits and sees the end of its generation, all
 * arrived or some given up, proposes it.
 *
 * <p>Calls, messages and timers in, effects out through a {@link SynodLink} and a {@link BarrierPort}.
 */
class BarrierProtocol implements SynodProtocol {

  private static final long NS_PER_MS = 1_000_000;
  private static final long NEVER = Long.MAX_VALUE;

  /** Message delays from a proposal until others know the decision, and one to spare. */
  private static final int DECIDE = 6;

  private final ProcessId me;
  private final SortedSet<ProcessId> first;
  private final BarrierCodec codec;
  private final BarrierSettings settings;
  private final SynodLink link;
  private final BarrierPort port;
  private final Synod synod;
  private final Suspicion suspicion;

  // What is decided: all generations up to this one.
  private long decided;
  private Outcomes outcomes = Outcomes.ALL_PASSED;

  // Who has arrived where nothing is decided, in this generation and in later ones.
  private final TreeMap<Long, SortedSet<ProcessId>> arrivals = new TreeMap<>();

  private long generation = 1;
  private BarrierOutcome outcome = BarrierOutcome.NONE_YET;
  private boolean waiting;
  private boolean isLate;
  private final Set<ProcessId> noted = new TreeSet<>();

  // Whom this robot gives up; nobody, unless it proposes so or is about to.
  private SortedSet<ProcessId> givenUp = new TreeSet<>();

  private long sayAtNs = NEVER;
  private long proposeAtNs = NEVER;
  private long deadlineNs = NEVER;
  private long nowNs;

  /**
   * @param first the members of generation 1, whose robots are those who vote; the same on every
   *     robot, for ever
   */
  BarrierProtocol(
      ProcessId me,
      SortedSet<ProcessId> first,
      BarrierSettings settings,
      Rng rng,
      SynodLink link,
      BarrierPort port,
      long nowNs) {
    this.me = me;
    this.first = Collections.unmodifiableSortedSet(new TreeSet<>(first));
    this.codec = new BarrierCodec(first);
    this.settings = settings;
    this.link = link;
    this.port = port;
    this.nowNs = nowNs;
    this.suspicion = new Suspicion(settings.silenceMs() * NS_PER_MS);
    this.synod = new Synod(me.robot(), robots(), me, settings.timing(), rng, link, new Decrees());
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      decided(known.number(), codec.read(known.value()));
    }
  }

  private Participants robots() {
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
      suspicion.expects(absent, now);
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
    if (waiting && now >= deadlineNs) {
      deadline();
    }
    if (waiting && now >= sayAtNs) {
      say();
    }
    if (waiting) {
      check();
    }
  }

  @Override
  public long wakeAtNs() {
    long ownNs = Math.min(deadlineNs, Math.min(proposeAtNs, sayAtNs));
    return waiting
        ? Math.min(synod.wakeAtNs(), Math.min(ownNs, suspicion.wakeAtNs(nowNs)))
        : synod.wakeAtNs();
  }

  // What is known.

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

  // The protocol.

  /** {@code who} has arrived in {@code itsGeneration}. */
  void count(ProcessId who, long itsGeneration) {
    if (itsGeneration > decided) {
      arrivals(itsGeneration).add(who);
      if (itsGeneration == generation) {
        suspicion.releases(who);
      }
    }
  }

  private void answer(Arrival m) {
    if (m.generation() <= decided) {
      tellOutcomes(m.from());
      return;
    }
    if (m.generation() > decided + 1) {
      // It knows outcomes that are not known here.
      synod.query(m.from().robot());
    }
    boolean hasArrived = arrivals(decided + 1).contains(me);
    port.send(m.from().robot(), new Here(me, decided + 1, hasArrived, m.generation()));
  }

  private void tellOutcomes(ProcessId to) {
    link.send(to.robot(), new SynodMessage.Decided(decided, codec.toValue(outcomes)));
  }

  /** Works for the end of this generation if it is in sight. */
  void check() {
    if (!isAllHere()) {
      givenUp = absent();
      if (!isLate) {
        givenUp.retainAll(suspicion.suspects(nowNs));
      }
      if (givenUp.isEmpty()) {
        // Whoever was silent is back.
        synod.stop();
        proposeAtNs = NEVER;
        return;
      }
    }
    if (synod.isProposing()) {
      return;
    }
    if (proposeAtNs == NEVER) {
      // In turn, for proposers defeat each other; but those before it may have crashed, and its own
      // turn must come before its deadline.
      long turnNs = DECIDE * settings.deltaMs() * NS_PER_MS;
      long rank = arrivals(generation).headSet(me).size();
      proposeAtNs = Math.max(nowNs, Math.min(nowNs + rank * turnNs, deadlineNs - turnNs));
    }
    if (nowNs >= proposeAtNs) {
      proposeAtNs = NEVER;
      synod.propose(generation, Value.EMPTY, wishes -> proposal(), nowNs);
    }
  }

  /** What is proposed, {@code Barrier_agreement.propose}, by what is known at the last moment. */
  private Value proposal() {
    return codec.toValue(isAllHere() ? outcomes : outcomes.withBroken(generation, givenUp));
  }

  /** The first time, who has not arrived is left out; the second time, nobody can be. */
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

  /** The wait is over, and so is the generation. */
  void next(BarrierOutcome told) {
    rest(told);
    generation++;
    noted.clear();
  }

  /** The wait is over. */
  private void rest(BarrierOutcome told) {
    outcome = told;
    waiting = false;
    deadlineNs = NEVER;
    sayAtNs = NEVER;
    proposeAtNs = NEVER;
    synod.stop();
    suspicion.expected().forEach(suspicion::releases);
  }

  /** Asks those who have not arrived, and tells those who have not noted that this robot has. */
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

  private final class Decrees implements SynodListener {
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
      decided(number, codec.read(value));
    }
  }
}
