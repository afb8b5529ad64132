package org.starl.launch;

import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.TreeSet;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.robot.trace.ProcessFact;
import org.starl.sim.Diagnosis;
import org.starl.sim.RunObservers;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.spec.Monitors;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * Shows the events of several processes as one run while they come. It holds each event back for a
 * time in which earlier events of other processes may come; one that comes still later gets the time
 * of the latest shown one. The app's monitors check this one order: {@link TraceMerge} judges all
 * possible orders, after the run. Thread-safe.
 */
public final class LiveMerge {

  /** How long an event waits for earlier ones, in the time of the run. */
  static final long HELD_NS = Time.NS_PER_S;

  private record Held(long timeNs, long number, TraceEvent event, boolean isOfWorld) {}

  private final PriorityQueue<Held> held =
      new PriorityQueue<>(Comparator.comparingLong(Held::timeNs).thenComparingLong(Held::number));
  private final RunObservers observers;
  private final Set<RobotId> simulated = new TreeSet<>();
  private final Beliefs beliefs = new Beliefs();
  private final Set<RobotId> onFloor = new TreeSet<>();
  private long number;
  private int behind;
  private long newestNs;
  private long shownNs;

  /**
   * Begins the run.
   *
   * @param observers of the merged run
   */
  public LiveMerge(SimulationPlan plan, List<? extends SimObserver> observers) {
    this.observers =
        new RunObservers(
            Monitors.of(plan.monitors()),
            List.copyOf(observers),
            violation -> Diagnosis.NONE,
            plan.commands());
    this.observers.started(plan.header());
    // As in a trace that is merged later: a machine with other work guarantees no times.
    this.observers.record(Fault.realTime(0));
  }

  /**
   * Takes an event.
   *
   * @param atNs its time in the merged run
   * @param hasTrueBodies whether its process knows the true bodies; other processes measure them
   */
  public synchronized void add(TraceEvent event, long atNs, boolean hasTrueBodies) {
    held.add(new Held(Math.max(0, atNs), number++, event, hasTrueBodies));
    reached(atNs);
  }

  /** Takes an event of a process that has the clock of this run and knows its true body. */
  public void accept(TraceEvent event) {
    if (ProcessFact.isProcessEvent(event)) {
      reached(event.timeNs());
    } else {
      add(event, event.timeNs(), true);
    }
  }

  /** A trace with events of the past follows: nothing is shown until {@link #caughtUp}. */
  synchronized void follows() {
    behind++;
  }

  /** A trace that followed has told its past. */
  synchronized void caughtUp() {
    behind--;
    reached(newestNs);
  }

  /** Tells that a process has come to this time. */
  public synchronized void reached(long atNs) {
    newestNs = Math.max(newestNs, atNs);
    if (behind == 0) {
      showUntil(newestNs - HELD_NS);
    }
  }

  /** Shows what is held back, and the end of the run; returns its time. */
  public synchronized long end() {
    showUntil(Long.MAX_VALUE);
    long endNs = Math.max(shownNs, newestNs);
    observers.endSpecifications(endNs);
    return endNs;
  }

  private void showUntil(long limitNs) {
    for (Held next = held.peek(); next != null && next.timeNs <= limitNs; next = held.peek()) {
      held.remove();
      shownNs = Math.max(shownNs, next.timeNs);
      show(next.event.at(shownNs), next.isOfWorld);
    }
  }

  /** Leaves out measured bodies where the true ones are known; a body joins once. */
  private void show(TraceEvent event, boolean hasTrueBodies) {
    RobotId robot = event.robot();
    switch (event) {
      case Joined joined -> {
        if (hasTrueBodies) {
          simulated.add(robot);
        } else if (simulated.contains(robot)) {
          believe(robot, joined.pose(), joined.timeNs());
          return;
        }
        boolean isAgain = !onFloor.add(robot);
        record(isAgain ? new Moved(joined.timeNs(), robot, joined.pose(), 0, 0) : joined);
      }
      case Moved moved -> {
        if (!hasTrueBodies && simulated.contains(robot)) {
          believe(robot, moved.pose(), moved.timeNs());
        } else if (onFloor.contains(robot)) {
          record(moved);
        }
      }
      case Left left -> {
        if (hasTrueBodies || !simulated.contains(robot)) {
          onFloor.remove(robot);
          record(left);
        }
      }
      default -> record(event);
    }
  }

  private void record(TraceEvent event) {
    beliefs.observe(event);
    observers.record(event);
  }

  private void believe(RobotId robot, Pose measured, long timeNs) {
    Variable belief = beliefs.of(robot, measured, timeNs);
    if (belief != null) {
      observers.record(belief);
    }
  }
}
