package org.starl.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;

/**
 * What the faults of a run leave of the assumptions under which progress is promised: whose program
 * is there, and whether the world behaves. For specifications; feed it every event.
 */
public final class Circumstances {

  private final Set<RobotId> down = new TreeSet<>();
  // The faults that do harm, each by whom it befalls and what it is; two may be equal.
  private final List<String> underWay = new ArrayList<>();

  /** The same at this moment, from now on apart. */
  public Circumstances copy() {
    Circumstances copy = new Circumstances();
    copy.down.addAll(down);
    copy.underWay.addAll(underWay);
    return copy;
  }

  /**
   * Sees the next event.
   *
   * @return whether anything asked here may have another answer now
   */
  public boolean observe(TraceEvent event) {
    return switch (event) {
      case Fault fault -> fault(fault);
      case Joined joined -> down.remove(joined.robot());
      case Left left -> down.add(left.robot());
      default -> false;
    };
  }

  /** Whether the robot has neither crashed for now nor left. */
  public boolean isUp(RobotId robot) {
    return !down.contains(robot);
  }

  /** Whether no fault but crashes is under way. */
  public boolean isFair() {
    return underWay.isEmpty();
  }

  private boolean fault(Fault fault) {
    String which = fault.robot() + " " + fault.detail();
    return switch (fault.name()) {
      case Fault.CRASH -> down.add(fault.robot());
      case Fault.RESTART -> down.remove(fault.robot());
      case Fault.BEGIN -> underWay.add(which);
      case Fault.END -> underWay.remove(which);
      case Fault.HEALED -> {
        boolean wasFoul = !underWay.isEmpty();
        underWay.clear();
        yield wasFoul;
      }
      default -> false;
    };
  }
}
