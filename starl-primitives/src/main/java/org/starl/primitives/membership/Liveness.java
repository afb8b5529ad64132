package org.starl.primitives.membership;

import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;

/**
 * The dead participants of a run: those of a program start that has ended, by a crash or because the
 * robot left. For specifications; pass it every event.
 */
public final class Liveness {

  private final FaultState faults = new FaultState();
  // The latest start of each robot's program, by the ids in its actions, and the latest ended one.
  // A crash alone does not tell: before the boot number is stored, the next start uses it again.
  private final Map<RobotId, Long> latest = new TreeMap<>();
  private final Map<RobotId, Long> ended = new TreeMap<>();
  // Each robot's id in its latest action, while it changes nothing: most actions repeat it.
  private final Map<RobotId, ProcessId> known = new TreeMap<>();

  /**
   * Sees the next event.
   *
   * @return whether some answer of this object may have changed
   */
  public boolean observe(TraceEvent event) {
    RobotId robot = event.robot();
    if (event instanceof Action action) {
      ProcessId id = action.process();
      if (id != null) {
        acted(robot, id);
      }
    } else if (event instanceof Left
        || (event instanceof Fault fault && fault.name().equals(Fault.CRASH))) {
      ended.put(robot, latest.getOrDefault(robot, 1L));
      known.remove(robot);
    }
    return faults.observe(event);
  }

  private void acted(RobotId robot, ProcessId id) {
    if (!id.equals(known.put(robot, id))) {
      long start = id.boot();
      latest.put(robot, start);
      ended.computeIfPresent(robot, (same, before) -> Math.min(before, start - 1));
    }
  }

  public boolean isDead(ProcessId id) {
    return id.boot() <= ended.getOrDefault(id.robot(), 0L);
  }

  public boolean isUp(RobotId robot) {
    return faults.isUp(robot);
  }

  /** As {@link FaultState#isCalm}. */
  public boolean isCalm(long nowNs, long settleNs) {
    return faults.isCalm(nowNs, settleNs);
  }

  /** Whether no fault but crashes is active. */
  public boolean isFair() {
    return faults.isFaultFree();
  }
}
