package org.starl.primitives.geocast;

import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.automaton.Fun;

/** Where the bodies were in the interval of one geocast: in its area, and always deep inside. */
interface Whereabouts {

  /** Begins to look at a body that is on the floor since {@code nowNs}. */
  void watch(RobotId robot, long nowNs);

  /**
   * Follows a body on the floor until {@code toNs}.
   *
   * @return whether it is found in the area for the first time
   */
  boolean follow(RobotId robot, Bodies bodies, double speedMmPerS, long toNs);

  /** The body leaves the floor. */
  void left(RobotId robot);

  /** Whether the body has been on the floor. */
  boolean hasSeen(RobotId robot);

  /** Whether the body was on the floor, and always outside. */
  boolean wasOutside(RobotId robot);

  /** Whether the body was deep inside throughout. */
  boolean wasDeep(RobotId robot);

  /** In an area with a border: each body is followed. */
  final class InArea implements Whereabouts {

    private final Region area;
    private final double deepMm;
    private final long startNs;
    private final SortedMap<RobotId, Presence> presences = new TreeMap<>();

    /**
     * @param deepMm the least distance from the border deep inside
     */
    InArea(Region area, double deepMm, long startNs) {
      this.area = area;
      this.deepMm = deepMm;
      this.startNs = startNs;
    }

    @Override
    public void watch(RobotId robot, long nowNs) {
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

    @Override
    public boolean follow(RobotId robot, Bodies bodies, double speedMmPerS, long toNs) {
      Presence presence = presences.get(robot);
      if (presence == null) {
        return false;
      }
      boolean wasIn = presence.everIn();
      presence.follow(bodies, speedMmPerS, toNs);
      return presence.everIn() && !wasIn;
    }

    @Override
    public void left(RobotId robot) {
      Presence presence = presences.get(robot);
      if (presence != null) {
        presence.interrupted();
      }
    }

    @Override
    public boolean hasSeen(RobotId robot) {
      return presences.containsKey(robot);
    }

    @Override
    public boolean wasOutside(RobotId robot) {
      Presence presence = presences.get(robot);
      return presence != null && !presence.everIn();
    }

    @Override
    public boolean wasDeep(RobotId robot) {
      Presence presence = presences.get(robot);
      return presence != null && presence.alwaysDeep();
    }
  }

  /** Everywhere: a body on the floor is deep inside, wherever it moves. */
  final class OnFloor implements Whereabouts {

    private final long startNs;
    private Fun<RobotId, Boolean> seen;
    private Fun<RobotId, Boolean> interrupted = Fun.always(false);

    /**
     * @param onFloor the bodies at the start
     */
    OnFloor(Fun<RobotId, Boolean> onFloor, long startNs) {
      seen = onFloor;
      this.startNs = startNs;
    }

    @Override
    public void watch(RobotId robot, long nowNs) {
      if (!seen.at(robot)) {
        seen = seen.with(robot, true);
        interrupted = interrupted.with(robot, nowNs > startNs);
      }
    }

    @Override
    public boolean follow(RobotId robot, Bodies bodies, double speedMmPerS, long toNs) {
      return false; // it was in the area from the first time on
    }

    @Override
    public void left(RobotId robot) {
      interrupted = interrupted.with(robot, seen.at(robot));
    }

    @Override
    public boolean hasSeen(RobotId robot) {
      return seen.at(robot);
    }

    @Override
    public boolean wasOutside(RobotId robot) {
      return false;
    }

    @Override
    public boolean wasDeep(RobotId robot) {
      return seen.at(robot) && !interrupted.at(robot);
    }
  }
}
