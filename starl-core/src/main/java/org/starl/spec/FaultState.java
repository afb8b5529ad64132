package org.starl.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;

/**
 * The state of a run's faults, as far as specifications need it: which robots' programs run, and
 * whether a fault is active. Progress is required only without faults. Pass it every event.
 */
public final class FaultState {

  /** After so long without faults all lost messages have been repeated, in ns. */
  public static final long SETTLE_NS = 10 * Time.NS_PER_S;

  private static final Set<String> OF_CLOCKS = Set.of("drift", "skew", Fault.REAL_TIME);
  private static final String FATE = "datagram";

  private final Set<RobotId> down = new TreeSet<>();
  // A fault may be in the list twice.
  private final List<Active> active = new ArrayList<>();
  // When a fault of the robot's clock last began or ended.
  private final Map<RobotId, Long> clockChangedNs = new TreeMap<>();
  // Single datagrams are late or lost, at times that no event tells.
  private boolean hasFates;
  // When the last change was; long ago at first.
  private long changedNs = Long.MIN_VALUE / 2;

  private record Active(RobotId robot, String effect, String detail) {}

  /** An independent copy of the current state. */
  public FaultState copy() {
    FaultState copy = new FaultState();
    copy.down.addAll(down);
    copy.active.addAll(active);
    copy.clockChangedNs.putAll(clockChangedNs);
    copy.hasFates = hasFates;
    copy.changedNs = changedNs;
    return copy;
  }

  /**
   * Processes the next event.
   *
   * @return whether the answer of any method here may have changed
   */
  public boolean observe(TraceEvent event) {
    boolean isChange =
        switch (event) {
          case Fault fault -> fault(fault);
          case Joined joined -> down.remove(joined.robot());
          case Left left -> down.add(left.robot());
          default -> false;
        };
    if (isChange) {
      changedNs = event.timeNs();
    }
    return isChange;
  }

  /** Whether the robot runs: it has neither crashed without restart nor left. */
  public boolean isUp(RobotId robot) {
    return !down.contains(robot);
  }

  /** Whether no fault except crashes is active. */
  public boolean isFaultFree() {
    return active.isEmpty();
  }

  /**
   * Whether no fault was active, every robot was up, and none came or left, in the {@code settleNs}
   * until {@code nowNs}: then messages that were lost before have been repeated. True before the
   * first fault; never after a fault has given the fate of a single datagram.
   */
  public boolean isCalm(long nowNs, long settleNs) {
    return !hasFates && active.isEmpty() && down.isEmpty() && nowNs - changedNs >= settleNs;
  }

  /**
   * Whether the robot's clock has run right since {@code sinceNs}: no drift and no skew has acted on it
   * since then. Not known of runs in real time.
   */
  public boolean isClockRight(RobotId robot, long sinceNs) {
    for (RobotId each : List.of(robot, Fault.WORLD)) {
      boolean isWrong =
          active.stream().anyMatch(f -> f.robot().equals(each) && OF_CLOCKS.contains(f.effect()));
      if (isWrong || clockChangedNs.getOrDefault(each, Long.MIN_VALUE) >= sinceNs) {
        return false;
      }
    }
    return true;
  }

  private boolean fault(Fault fault) {
    if (fault.isOfCrashes()) {
      return false;
    }
    if (OF_CLOCKS.contains(fault.effect())) {
      clockChangedNs.put(fault.robot(), fault.timeNs());
    }
    hasFates |= fault.effect().equals(FATE);
    Active which = new Active(fault.robot(), fault.effect(), fault.detail());
    return switch (fault.name()) {
      case Fault.CRASH -> down.add(fault.robot());
      case Fault.RESTART -> down.remove(fault.robot());
      case Fault.BEGIN -> active.add(which);
      case Fault.END -> active.remove(which);
      case Fault.HEALED -> {
        boolean anyActive = !active.isEmpty();
        active.clear();
        yield anyActive;
      }
      default -> false;
    };
  }
}
