package org.starl.primitives.membership;

import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;

/**
 * The dead participants of a run: those of a program start that has ended, by a crash or because the
 * robot left. For specifications; pass it every event.
 */
public final class Liveness {

  private final FaultState faults = new FaultState();
  // The number of ended starts of each robot's program.
  private final Map<RobotId, Long> ended = new TreeMap<>();

  /**
   * Sees the next event.
   *
   * @return whether some answer of this object may have changed
   */
  public boolean observe(TraceEvent event) {
    boolean ends =
        event instanceof Left || (event instanceof Fault fault && fault.name().equals(Fault.CRASH));
    if (ends && faults.isUp(event.robot())) {
      ended.merge(event.robot(), 1L, Long::sum);
    }
    return faults.observe(event);
  }

  public boolean isDead(ProcessId id) {
    // The ids of a closed group are of the first start.
    long start = Math.max(1, id.inc() >>> Integer.SIZE);
    return start <= ended.getOrDefault(id.robot(), 0L);
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
