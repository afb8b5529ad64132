package org.starl.primitives.geocast;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;

/** What {@link Casts} and {@link GeocastSpec} know of one geocast whose interval is not over. */
final class CastRecord {

  /** A datagram, by its sender and its number. */
  record Copy(RobotId origin, long seq) {}

  final String source;
  final RobotId origin;
  final String id;
  final Region area;
  final long startNs;
  final long deadlineNs;

  /** Those who took part at t0 and have not restarted since; of them inclusion is owed. */
  final Set<RobotId> owed = new TreeSet<>();

  /**
   * The origin has restarted since: it numbers its datagrams anew, and copies are not known any
   * more.
   */
  boolean originRestarted;

  /** The copies that the origin has sent. */
  final Set<Copy> copies = new HashSet<>();

  /** Those whom a copy has reached. */
  final Set<RobotId> reached = new TreeSet<>();

  /** Who delivered, and has not restarted since. */
  final Set<RobotId> holders = new TreeSet<>();

  /** Who delivered, and when, the first time. */
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

  /** A datagram has reached somebody: whether it is a copy, for certain. */
  boolean isCopy(Copy datagram) {
    return !originRestarted && copies.contains(datagram);
  }

  /** Begins to follow a body that is on the floor at {@code nowNs}. */
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
   * @return whether it is found to have been in the area, and was not before
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

  /** When a robot that delivered did so first. */
  long deliveredAtNs(RobotId robot) {
    return deliveredNs.getOrDefault(robot, startNs);
  }

  /** Robots that delivered though they were outside throughout, as far as bodies are known. */
  List<RobotId> intruders() {
    List<RobotId> intruders = new ArrayList<>();
    for (RobotId robot : deliveredNs.keySet()) {
      Presence presence = presences.get(robot);
      if (presence != null && !presence.everIn()) {
        intruders.add(robot);
      }
    }
    return intruders;
  }

  /** Robots that had to deliver: in reach, deep inside throughout. */
  List<RobotId> debtors() {
    List<RobotId> debtors = new ArrayList<>();
    for (RobotId robot : owed) {
      Presence presence = presences.get(robot);
      boolean inside = presence != null && presence.alwaysDeep();
      // Without any copy the network is not to blame.
      if (inside && (copies.isEmpty() || reached.contains(robot))) {
        debtors.add(robot);
      }
    }
    return debtors;
  }
}
