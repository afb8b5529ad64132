package org.starl.primitives.barrier;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.Value;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/** One barrier, as {@link BarrierSpec} sees it in the trace. */
final class BarrierRecord {

  private final Instance source;
  private final FaultState faults;
  private final SortedSet<ProcessId> first = new TreeSet<>();
  private final Set<RobotId> seen = new TreeSet<>();

  // For each robot that is up: its id, and the generation in which it waits.
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final Map<RobotId, Long> waiting = new TreeMap<>();

  // The latest generation of which each robot was told.
  private final Map<RobotId, Long> known = new TreeMap<>();

  private final Map<Long, Set<ProcessId>> arrived = new TreeMap<>();
  private final Map<Long, First> outcomes = new TreeMap<>();
  private final Map<Long, Set<ProcessId>> excluded = new TreeMap<>();
  private Outcomes missing = Outcomes.ALL_PASSED;

  // Each names the members that some robot has given up.
  private final Set<Value> proposed = new LinkedHashSet<>();

  /** The first robot to be told the outcome of a generation, and the outcome: passed or failed. */
  private record First(RobotId robot, BarrierOutcome outcome) {}

  BarrierRecord(Instance source, FaultState faults) {
    this.source = source;
    this.faults = faults;
  }

  void created(ProcessId id, Collection<ProcessId> members) {
    seen.add(id.robot());
    ids.put(id.robot(), id);
    first.addAll(members);
  }

  void arrived(long generation, ProcessId id) {
    arrived.computeIfAbsent(generation, g -> new TreeSet<>()).add(id);
    boolean isExcluded = excluded.values().stream().anyMatch(ids -> ids.contains(id));
    if (first.contains(id) && !isExcluded) {
      waiting.put(id.robot(), generation);
    }
  }

  /** The members that its sender gives up by this message; none if it repeats another one's value. */
  Set<ProcessId> givenUp(SynodMessage.Accept accept) {
    if (!proposed.add(accept.value())) {
      return Set.of();
    }
    Outcomes outcomes = new OutcomesFormat(first).read(accept.value());
    return outcomes.isBroken(accept.number()) ? outcomes.missing(accept.number()) : Set.of();
  }

  void ended(RobotId robot) {
    ids.remove(robot);
    waiting.remove(robot);
    known.remove(robot);
  }

  /** The generations in which the robot's present program has arrived. */
  Set<Long> arrivals(RobotId robot) {
    ProcessId id = ids.get(robot);
    Set<Long> generations = new TreeSet<>();
    arrived.forEach((generation, here) -> {
      if (id != null && here.contains(id)) {
        generations.add(generation);
      }
    });
    return generations;
  }

  /** Whether the robot must answer: a member's arrival, or one that is in a generation that it knows. */
  boolean mustAnswer(RobotId robot, BarrierMessage message) {
    boolean isBehind =
        message instanceof BarrierMessage.Here here
            && here.generation() <= known.getOrDefault(robot, 0L);
    return first.contains(message.from())
        && ids.containsKey(robot)
        && (isBehind || message instanceof BarrierMessage.Arrival);
  }

  void told(Variable variable, BarrierOutcome outcome, Report report) {
    if (!outcome.isTold()) {
      return;
    }
    waiting.remove(variable.robot());
    switch (outcome) {
      case BarrierOutcome.Passed all -> {
        known.put(variable.robot(), all.generation());
        passed(all.generation(), variable, report);
        decided(all.generation(), outcome, variable, report);
      }
      case BarrierOutcome.Failed some -> {
        known.put(variable.robot(), some.generation());
        decided(some.generation(), outcome, variable, report);
      }
      case BarrierOutcome.Excluded out -> excluded(out.generation(), variable, report);
      case BarrierOutcome.NoneYet none -> {
        // No claim to check.
      }
      case BarrierOutcome.Unknown open -> {
        // No claim to check.
      }
    }
  }

  private void excluded(long generation, Variable variable, Report report) {
    ProcessId id = ids.get(variable.robot());
    if (generation > 0 && id != null) {
      excluded.computeIfAbsent(generation, g -> new TreeSet<>()).add(id);
      uniform(generation, variable, report);
    }
  }

  private void passed(long generation, Variable variable, Report report) {
    report.checked(BarrierSpec.NO_EARLY);
    SortedSet<ProcessId> late = missing.members(first, generation);
    late.removeAll(arrived.getOrDefault(generation, Set.of()));
    if (!late.isEmpty()) {
      report.violated(
          BarrierSpec.NO_EARLY,
          variable.timeNs(),
          List.of(variable.robot()),
          source + ": passed in " + generation + " without " + late);
    }
  }

  private void decided(long generation, BarrierOutcome outcome, Variable variable, Report report) {
    if (outcomes.putIfAbsent(generation, new First(variable.robot(), outcome)) == null
        && outcome instanceof BarrierOutcome.Failed some) {
      missing = missing.withBroken(generation, some.missing());
    }
    First told = outcomes.get(generation);
    if (told != null && !told.outcome().equals(outcome)) {
      report.checked(BarrierSpec.UNIFORM);
      report.violated(
          BarrierSpec.UNIFORM,
          variable.timeNs(),
          List.of(told.robot(), variable.robot()),
          source + ": " + told.outcome() + " and " + outcome);
    } else {
      uniform(generation, variable, report);
    }
  }

  /** An excluded robot must be missing in the outcome, if the outcome is known. */
  private void uniform(long generation, Variable variable, Report report) {
    report.checked(BarrierSpec.UNIFORM);
    First told = outcomes.get(generation);
    Set<ProcessId> out = excluded.getOrDefault(generation, Set.of());
    if (told == null || out.isEmpty()) {
      return;
    }
    if (!missing.isBroken(generation) || !missing.missing(generation).containsAll(out)) {
      report.violated(
          BarrierSpec.UNIFORM,
          variable.timeNs(),
          List.of(told.robot(), variable.robot()),
          source + ": " + told.outcome() + ", excluded " + out);
    }
  }

  /** Every robot seen so far, in order. */
  Set<RobotId> robots() {
    return seen;
  }

  boolean isUp(RobotId robot) {
    return ids.containsKey(robot) && faults.isUp(robot);
  }

  boolean isWaiting(RobotId robot) {
    return isUp(robot) && waiting.containsKey(robot);
  }

  /** Whether each member of the generation in which {@code robot} waits has arrived or is dead. */
  boolean isNoneToCome(RobotId robot) {
    return haveArrived(robot, this::isLive);
  }

  /** Whether each member of the generation in which {@code robot} waits has arrived. */
  boolean haveAllArrived(RobotId robot) {
    return haveArrived(robot, member -> true);
  }

  private boolean haveArrived(RobotId robot, Predicate<ProcessId> isAwaited) {
    Long generation = waiting.get(robot);
    if (generation == null) {
      return false;
    }
    Set<ProcessId> here = arrived.getOrDefault(generation, Set.of());
    return missing.members(first, generation).stream().filter(isAwaited).allMatch(here::contains);
  }

  private boolean isLive(ProcessId member) {
    return isUp(member.robot()) && member.equals(ids.get(member.robot()));
  }

  /** Whether a majority of the acceptors is up: a robot of two members is one acceptor. */
  boolean hasMajorityUp() {
    Set<RobotId> acceptors = new TreeSet<>();
    first.forEach(member -> acceptors.add(member.robot()));
    long up = acceptors.stream().filter(this::isUp).count();
    return 2 * up > acceptors.size();
  }
}
