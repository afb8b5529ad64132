package org.starl.primitives.geocast;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;

/** One geocast whose interval is not over, as {@link Casts} and {@link GeocastSpec} follow it. */
final class CastRecord {

  /** A datagram, identified by its sender and number. */
  record Copy(RobotId origin, long seq) {}

  final String source;
  final RobotId origin;
  final String id;
  final Region area;
  final long startNs;
  final long deadlineNs;

  /** Robots that took part at t0 and have not restarted since: inclusion is owed to them. */
  final Set<RobotId> owed = new TreeSet<>();

  /** Whether the origin has restarted: its datagram numbers begin again, so copies are unknown. */
  boolean originRestarted;

  /** The copies that the origin has sent. */
  final Set<Copy> copies = new HashSet<>();

  /** Robots that a copy has reached. */
  final Set<RobotId> reached = new TreeSet<>();

  /** Robots that delivered, and have not restarted since. */
  final Set<RobotId> holders = new TreeSet<>();

  /** The time of each robot's first delivery. */
  final SortedMap<RobotId, Long> deliveredNs = new TreeMap<>();

  private final SortedMap<RobotId, Presence> presences = new TreeMap<>();

  CastRecord(String source, RobotId origin, String id, Region area, long startNs, long deadlineNs) {
    this.source = source;
    this.origin = origin;
    this.id = id;
    this.area = area;
    this.startNs = startNs;
    this.deadlineNs = deadlineNs;
  }

  /** Whether a datagram is certainly a copy. */
  boolean isCopy(Copy datagram) {
    return !originRestarted && copies.contains(datagram);
  }

  /** Begins to follow a body that is on the floor since {@code nowNs}. */
  void watch(RobotId robot, double deepMm, long nowNs) {
    Presence known = presences.get(robot);
    if (known != null) {
      known.resume(nowNs);
      return;
    }
    Presence presence = new Presence(robot, area, deepMm, nowNs);
    if (nowNs > startNs) {
      presence.interrupted();
    }
    presences.put(robot, presence);
  }

  /**
   * Follows one body until {@code nowNs} or the deadline.
   *
   * @return whether the body is found in the area for the first time
   */
  boolean follow(RobotId robot, Bodies bodies, Map<RobotId, Double> speeds, long nowNs) {
    Presence presence = presences.get(robot);
    if (presence == null || !bodies.isOnFloor(robot)) {
      return false;
    }
    boolean wasIn = presence.everIn();
    double speedMmPerS = speeds.getOrDefault(robot, 0.0);
    presence.follow(bodies, speedMmPerS, Math.min(nowNs, deadlineNs));
    return presence.everIn() && !wasIn;
  }

  /** Whether the body has been on the floor. */
  boolean hasSeen(RobotId robot) {
    return presences.containsKey(robot);
  }

  /** The body leaves the floor. */
  void left(RobotId robot) {
    Presence presence = presences.get(robot);
    if (presence != null) {
      presence.interrupted();
    }
  }

  void excuse(RobotId robot) {
    owed.remove(robot);
  }

  void restarted(RobotId robot) {
    originRestarted |= robot.equals(origin);
    owed.remove(robot);
    holders.remove(robot);
  }

  /** The time of the first delivery by a robot. */
  long deliveredAtNs(RobotId robot) {
    return deliveredNs.getOrDefault(robot, startNs);
  }

  /** Robots with known bodies that delivered although they were always outside. */
  List<RobotId> intruders() {
    return deliveredNs.keySet().stream()
        .filter(robot -> presences.containsKey(robot) && !presences.get(robot).everIn())
        .collect(Collectors.toList());
  }

  /**
   * Robots that had to deliver: reached by a copy, and always deep inside.
   *
   * @param reachesAll whether repeated copies reach all robots that take part
   */
  List<RobotId> required(boolean reachesAll) {
    boolean isCertain = copies.isEmpty() || (reachesAll && !originRestarted);
    // If the origin sent no copy, the network is not the cause.
    return owed.stream()
        .filter(robot -> presences.containsKey(robot) && presences.get(robot).alwaysDeep())
        .filter(robot -> isCertain || reached.contains(robot))
        .collect(Collectors.toList());
  }
}
