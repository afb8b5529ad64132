package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;
import org.starl.geometry.Angles;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.Contact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.paths.Path;

/**
 * Drives along a path, point by point, and records contacts and the robot's own trail. Strand only.
 */
final class Ride {

  /** State of the latest ride. */
  enum State {
    UNDER_WAY,
    ARRIVED,
    /** Has touched something; the collision mode moves the robot. */
    BUMPED,
    /** Stopped without a contact: no fix, or stuck wheels. */
    HELD_UP
  }

  // Attempts in a row through a narrow gap or back along the trail.
  private static final int TRIES_WHEN_LOST = 30;

  private static final double PASS_MM = 20;
  private static final double LONGEST_LEG_MM = 1_000;
  private static final double STRAIGHT_RAD = Angles.fromDegrees(1);
  private static final double TRAIL_STEP_MM = 40;
  private static final int LONGEST_TRAIL = 500;
  private static final double LEAST_RETREAT_MM = 30;
  private static final double RETREAT_TO_MM = 20;

  private final GlobalVarHolder gvh;
  private final RobotType own;
  private final List<Contact> contacts = new ArrayList<>();
  private final List<Point> trail = new ArrayList<>();
  private List<Point> ahead = List.of();
  private double toleranceMm;
  private int lost;

  Ride(GlobalVarHolder gvh) {
    this.gvh = gvh;
    own = gvh.plat.moat.parameters().robotType();
    gvh.plat.moat.onContact(contacts::add);
  }

  /**
   * Starts to drive.
   *
   * @param lastMm the ride ends when the robot is nearer to the end than this
   */
  void along(Path path, double lastMm, CollisionMode mode) {
    contacts.clear();
    ahead = cut(path);
    toleranceMm = lastMm;
    MotionParameters usual = gvh.plat.moat.parameters();
    gvh.plat.moat.setParameters(
        usual.toBuilder()
            .constantSpeed()
            .collisionPolicy(mode.policy())
            .robotType(own == RobotType.GOAL ? mode.robotType() : own)
            .goalRadiusMm(PASS_MM)
            .smallTurnAngleRad(STRAIGHT_RAD)
            .enableArcing(false)
            .build());
    toNext();
  }

  /** Drives on; call it once a period. */
  State step() {
    extendTrail();
    if (!contacts.isEmpty()) {
      return State.BUMPED;
    }
    MotionFlag flag = gvh.plat.moat.motionflag().get();
    if (flag == MotionFlag.DONE) {
      if (ahead.size() == 1 && isAt(ahead.get(0))) {
        return State.ARRIVED;
      }
      ahead = ahead.size() == 1 ? ahead : ahead.subList(1, ahead.size());
      toNext();
    }
    return flag == MotionFlag.FAIL ? State.HELD_UP : State.UNDER_WAY;
  }

  /** A fix since the arrival may tell that the robot is not there yet. */
  private boolean isAt(Point end) {
    return gvh.gps.pose().at().distanceMm(end) <= toleranceMm + gvh.gps.errorMm();
  }

  void stop() {
    extendTrail();
    gvh.plat.moat.motion_stop();
  }

  /** The contacts since the start of the ride. */
  List<Contact> contacts() {
    return List.copyOf(contacts);
  }

  /** Whether to try what was found: narrow ways, and none, only so often in a row. */
  boolean mayTry(Search.Outcome found) {
    boolean isWide = found instanceof Search.Outcome.Way way && !way.isNarrow();
    lost = isWide ? 0 : lost + 1;
    return lost <= TRIES_WHEN_LOST;
  }

  /**
   * Starts to drive back to the latest point of its trail that {@code isAllowed}, and forgets the
   * trail from there on.
   *
   * @return false if there is no such point
   */
  boolean retreat(Predicate<Point> isAllowed) {
    Point here = gvh.gps.pose().at();
    for (int i = trail.size() - 1; i >= 0; i--) {
      Point at = trail.get(i);
      if (at.distanceMm(here) >= LEAST_RETREAT_MM && isAllowed.test(at)) {
        trail.subList(i + 1, trail.size()).clear();
        along(new Path(List.of(here, at)), RETREAT_TO_MM, CollisionMode.BACK);
        return true;
      }
    }
    return false;
  }

  private void toNext() {
    Point next = ahead.get(0);
    MotionParameters usual = gvh.plat.moat.parameters();
    if (ahead.size() == 1) {
      double radiusMm = Math.min(usual.goalRadiusMm(), toleranceMm);
      gvh.plat.moat.setParameters(usual.toBuilder().goalRadiusMm(radiusMm).build());
    }
    gvh.plat.moat.doMove(new ItemPosition("way", next.xMm(), next.yMm()));
    gvh.plat.moat.setParameters(usual);
  }

  private void extendTrail() {
    Point at = gvh.gps.pose().at();
    if (trail.isEmpty() || trail.get(trail.size() - 1).distanceMm(at) >= TRAIL_STEP_MM) {
      trail.add(at);
      if (trail.size() > LONGEST_TRAIL) {
        trail.remove(0);
      }
    }
  }

  /** The points to drive to. Legs are short, as a robot strays farther on a longer leg. */
  private static List<Point> cut(Path path) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < path.legs(); i++) {
      Point from = path.leg(i).from();
      Point way = path.leg(i).to().minus(from);
      int pieces = (int) Math.max(1, StrictMath.ceil(way.normMm() / LONGEST_LEG_MM));
      for (int j = 1; j <= pieces; j++) {
        points.add(from.plus(way.times((double) j / pieces)));
      }
    }
    return points;
  }
}
