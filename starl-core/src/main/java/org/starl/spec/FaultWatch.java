package org.starl.spec;

import java.util.Collections;
import java.util.Set;
import java.util.TreeSet;
import org.starl.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * What is wrong with the world at present, for specifications whose progress is owed only while
 * nothing is: {@code within.assumeAll(faults.isCalm(), event.timeNs())} at every event.
 */
public final class FaultWatch {

  private final Set<RobotId> down = new TreeSet<>();
  private boolean isCalm = true;

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    if (!(event instanceof Fault fault)) {
      if (event instanceof TraceEvent.Left) {
        down.remove(event.robot());
      }
      return;
    }
    switch (fault.name()) {
      case Fault.CRASH -> down.add(fault.robot());
      case Fault.RESTART -> down.remove(fault.robot());
      case Fault.BEGIN -> isCalm = false;
      case Fault.HEALED -> isCalm = true;
      default -> {
        // One has ended: others may be at work, or to come.
      }
    }
  }

  /**
   * Whether the world behaves: no fault has begun yet, or all have ended and none will begin. Who
   * crashed for good is dead nevertheless, see {@link #isDown}.
   */
  public boolean isCalm() {
    return isCalm;
  }

  /** Whether this robot's program has crashed and not been restarted. */
  public boolean isDown(RobotId robot) {
    return down.contains(robot);
  }

  /** Those that are down, in order. */
  public Set<RobotId> down() {
    return Collections.unmodifiableSet(down);
  }
}
