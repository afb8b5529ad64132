package org.starl.primitives.geocast;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Fun;
import org.starl.trace.Instance;

/** One geocast whose interval is not over, as {@link Casts} and {@link GeocastSpec} follow it. */
final class CastRecord {

  final Instance source;
  final RobotId origin;
  final GeocastId id;
  final Region area;
  final long startNs;
  final long deadlineNs;

  /** Robots that took part at t0 and have not restarted since: inclusion is owed to them. */
  private Fun<RobotId, Boolean> owed;

  /** Whether the origin has restarted: it repeats no copies any more. */
  boolean originRestarted;

  /** Whether the origin has sent a copy. */
  boolean hasCopies;

  private final RobotNumbers numbers;

  /** Robots that a copy has reached. */
  private final BitSet reached = new BitSet();

  /** Robots that delivered, and have not restarted since. */
  private final BitSet holders = new BitSet();

  /** Robots that delivered. */
  private final BitSet delivered = new BitSet();

  /** The time of each robot's first delivery, if the area has an outside. */
  private final SortedMap<RobotId, Long> deliveredNs = new TreeMap<>();

  final Whereabouts bodies;

  /**
   * @param members the robots that take part in the instance
   */
  CastRecord(
      Instance source,
      RobotId origin,
      GeocastId id,
      Region area,
      long startNs,
      long deadlineNs,
      RobotNumbers numbers,
      Fun<RobotId, Boolean> members,
      Whereabouts bodies) {
    this.source = source;
    this.origin = origin;
    this.id = id;
    this.area = area;
    this.startNs = startNs;
    this.deadlineNs = deadlineNs;
    this.numbers = numbers;
    this.bodies = bodies;
    owed = members.with(origin, false);
  }

  boolean isEverywhere() {
    return area instanceof Everywhere;
  }

  void excuse(RobotId robot) {
    owed = owed.with(robot, false);
  }

  void restarted(RobotId robot) {
    originRestarted |= robot.equals(origin);
    owed = owed.with(robot, false);
    holders.clear(numbers.of(robot));
  }

  void reached(RobotId robot) {
    reached.set(numbers.of(robot));
  }

  /**
   * Records a delivery.
   *
   * @return whether it is the robot's first one since its latest start
   */
  boolean delivered(RobotId robot, long timeNs) {
    int number = numbers.of(robot);
    boolean isFirst = !holders.get(number);
    holders.set(number);
    if (!delivered.get(number)) {
      delivered.set(number);
      if (!isEverywhere()) {
        deliveredNs.put(robot, timeNs);
      }
    }
    return isFirst;
  }

  boolean hasDelivered(RobotId robot) {
    return delivered.get(numbers.of(robot));
  }

  /** How many robots delivered. */
  int deliveries() {
    return delivered.cardinality();
  }

  /** Robots with known bodies that delivered although they were always outside: each with the time. */
  Map<RobotId, Long> intruders() {
    SortedMap<RobotId, Long> intruders = new TreeMap<>(deliveredNs);
    intruders.keySet().removeIf(robot -> !bodies.wasOutside(robot));
    return intruders;
  }

  /**
   * Robots that had to deliver: reached by a copy, and always deep inside.
   *
   * @param reachesAll whether repeated copies reach all robots that take part
   */
  List<RobotId> required(boolean reachesAll) {
    boolean isCertain = !hasCopies || (reachesAll && !originRestarted);
    // If the origin sent no copy, the network is not the cause.
    return owed.arguments().stream()
        .filter(bodies::wasDeep)
        .filter(robot -> isCertain || reached.get(numbers.of(robot)))
        .collect(Collectors.toList());
  }
}
