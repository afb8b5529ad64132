package org.starl.primitives.motion;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.motion.MotionFailure;
import org.starl.time.Time;
import org.starl.trace.TraceEvent.Fault;

/** The faults that robots' fixes and bodies have had: which failures of a motion may be true. */
final class FixFaults {

  /** So long a fault may have an effect: until fixes that contradict the others are believed. */
  private static final long EFFECT_NS = 30 * Time.NS_PER_S;

  private static final Set<String> VAGUE = Set.of("noise");

  /** Also clocks: a command may be in effect for longer, by the robot's clock, than it assumes. */
  private static final Set<String> CONTRADICTING = Set.of("jump", "ram", "block", "drift", "skew");

  /** A robot accepts no fix as long as one of these acts on it. */
  private static final Set<String> BLINDING = Set.of("dropout", "jump");

  private record Kind(RobotId robot, String effect) {}

  private final Map<Kind, Integer> active = new LinkedHashMap<>();
  private final Map<Kind, Long> endedNs = new LinkedHashMap<>();
  private final Map<RobotId, Long> blindFromNs = new TreeMap<>();

  void observe(Fault fault) {
    Kind kind = new Kind(fault.robot(), fault.effect());
    if (fault.name().equals(Fault.BEGIN)) {
      active.merge(kind, 1, Integer::sum);
    } else if (fault.name().equals(Fault.END)) {
      active.merge(kind, -1, Integer::sum);
      endedNs.put(kind, fault.timeNs());
    }
    if (BLINDING.stream().anyMatch(effect -> isActive(new Kind(fault.robot(), effect)))) {
      blindFromNs.putIfAbsent(fault.robot(), fault.timeNs());
    } else {
      blindFromNs.remove(fault.robot());
    }
  }

  /** Since when faults of this robot alone have left it without a fix; {@code orElse} if none does. */
  long blindFromNs(RobotId robot, long orElse) {
    return blindFromNs.getOrDefault(robot, orElse);
  }

  /**
   * Whether the reason may be true.
   *
   * @param fixAgeNs an older fix stops the wheels
   */
  boolean allow(MotionFailure why, RobotId robot, long fixAgeNs, long nowNs) {
    return switch (why) {
      case NO_FIX -> haveActed(robot, Set.of("dropout"), nowNs - fixAgeNs);
      case UNCERTAIN -> haveActed(robot, VAGUE, nowNs - EFFECT_NS);
      case CONTRADICTED -> haveActed(robot, CONTRADICTING, nowNs - EFFECT_NS);
      default -> true;
    };
  }

  private boolean haveActed(RobotId robot, Set<String> effects, long sinceNs) {
    return effects.stream()
        .anyMatch(effect ->
            hasActed(new Kind(robot, effect), sinceNs)
                || hasActed(new Kind(Fault.WORLD, effect), sinceNs));
  }

  private boolean hasActed(Kind kind, long sinceNs) {
    return isActive(kind) || endedNs.getOrDefault(kind, Long.MIN_VALUE) >= sinceNs;
  }

  private boolean isActive(Kind kind) {
    return active.getOrDefault(kind, 0) > 0;
  }
}
