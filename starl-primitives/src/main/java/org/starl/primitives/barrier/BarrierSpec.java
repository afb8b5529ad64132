package org.starl.primitives.barrier;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Dues;
import org.starl.spec.Dues.Seat;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/**
 * What every barrier of a run owes, as the package's contract has it: {@code NoEarly}, {@code
 * Uniform}, and, where bounds are given, {@code NotHung}. Instances are told apart by their names.
 */
public final class BarrierSpec implements Monitor {

  static final String NO_EARLY = "NoEarly";
  static final String UNIFORM = "Uniform";
  static final String NOT_HUNG = "NotHung";

  private final Dues released;
  private final Dues told;
  private final Circumstances circumstances = new Circumstances();
  private final Map<String, Generations> barriers = new TreeMap<>();

  /** Safety only. */
  public BarrierSpec() {
    this(Dues.NO_BOUND, Dues.NO_BOUND);
  }

  /**
   * Safety, and progress within bounds.
   *
   * @param releasedWithinNs who waits is told within this time of the last arrival of a live member,
   *     or of a crash that leaves none to arrive; while a majority of the members' robots is up and
   *     no fault is under way; in ns
   * @param toldWithinNs who waits is told something within this time, whatever happens, in ns: two of
   *     the barriers' deadlines
   */
  public BarrierSpec(long releasedWithinNs, long toldWithinNs) {
    released =
        new Dues(
            NOT_HUNG,
            releasedWithinNs,
            sinceNs -> "waits, though nobody is to come, since " + sinceNs + " ns");
    told = new Dues(NOT_HUNG, toldWithinNs, sinceNs -> "waits since " + sinceNs + " ns");
  }

  @Override
  public List<String> lemmas() {
    return released.isBounded() ? List.of(NO_EARLY, UNIFORM, NOT_HUNG) : List.of(NO_EARLY, UNIFORM);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case NO_EARLY -> "Nobody passes the barrier before all its members have arrived.";
      case UNIFORM -> "All who wait at one barrier are told the same outcome.";
      case NOT_HUNG -> "Whoever waits at a barrier is told something within the bound.";
      default -> "";
    };
  }

  @Override
  public List<String> ownLemmas() {
    return List.of(UNIFORM);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new BarrierConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    boolean changed = circumstances.observe(event);
    switch (event) {
      case Action action when BarrierTrace.isBarrier(action.source()) -> {
        acted(action);
        changed = true;
      }
      case Variable variable
          when BarrierTrace.isBarrier(variable.source())
              && variable.name().equals(BarrierTrace.OUTCOME) -> {
        generations(variable.source()).told(variable, report);
        changed = true;
      }
      case Fault fault when fault.name().equals(Fault.CRASH) -> forget(fault.robot());
      case Left left -> forget(left.robot());
      default -> {
        // Of no concern here.
      }
    }
    if (changed) {
      owe(event.timeNs(), report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void acted(Action action) {
    Generations generations = generations(action.source());
    List<String> args = action.args();
    if (action.name().equals(BarrierTrace.BARRIER)) {
      List<ProcessId> ids = args.stream().map(ProcessId::parse).collect(Collectors.toList());
      generations.made(ids.get(0), ids.subList(1, ids.size()));
    } else if (action.name().equals(BarrierTrace.ARRIVE)) {
      generations.arrived(Long.parseLong(args.get(0)), ProcessId.parse(args.get(1)));
    }
  }

  private void forget(RobotId robot) {
    barriers.values().forEach(generations -> generations.crashed(robot));
  }

  /** Brings all debts up to date. */
  private void owe(long nowNs, Report report) {
    if (!released.isBounded()) {
      return;
    }
    barriers.forEach((source, generations) -> {
      boolean fair = circumstances.isFair() && generations.hasMajorityUp();
      for (RobotId robot : generations.robots()) {
        Seat seat = new Seat(source, robot);
        if (generations.isWaiting(robot)) {
          told.owe(seat, nowNs);
          released.owe(seat, nowNs);
          released.assume(seat, fair && generations.isNobodyToCome(robot), nowNs);
        } else {
          released.settle(seat);
          if (told.settle(seat) && generations.isUp(robot)) {
            report.checked(NOT_HUNG);
          }
        }
      }
    });
  }

  private void expire(long nowNs, Report report) {
    released.expire(nowNs, report);
    told.expire(nowNs, report);
  }

  private Generations generations(String source) {
    return barriers.computeIfAbsent(source, s -> new Generations(s, circumstances));
  }
}
