package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.motion.Contact;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeSettings;
import org.starl.random.Rng;

/**
 * Drives along a path, a piece at a time and each piece in a reach tube of its own, and records
 * contacts and the robot's own trail. Strand only.
 */
final class Ride {

  /** State of the latest ride. */
  enum State {
    UNDER_WAY,
    ARRIVED,
    /** Has driven the first piece of a path that is too long for one tube. */
    PART_WAY,
    /** Has touched something; the collision mode moves the robot. */
    BUMPED,
    /** Has not set out, because tubes of other robots are in the way. */
    REFUSED,
    /** Stopped without a contact: no fix, or stuck wheels. */
    HELD_UP
  }

  /** A point on the way is passed within this distance. */
  static final double PASS_MM = 20;

  // Attempts in a row through a narrow gap or back along the trail.
  private static final int TRIES_WHEN_LOST = 30;

  private static final int LEG_MM = 400;
  private static final int ERROR_MM = 30;
  private static final double STEP_MM = 15;
  private static final double STRAIGHT_RAD = Angles.fromDegrees(1);
  private static final double TRAIL_STEP_MM = 40;
  private static final int LONGEST_TRAIL = 500;
  private static final double LEAST_RETREAT_MM = 30;

  // A longer piece holds up more robots; a shorter one is claimed more often.
  private static final double LONGEST_PIECE_MM = 3_000;

  private final GlobalVarHolder gvh;
  private final RobotType own;
  private final DistributedPathPlanning paths;
  private final List<Contact> contacts = new ArrayList<>();
  private final List<Point> trail = new ArrayList<>();
  private Path way;
  private boolean isWhole;
  private int lost;

  /** Changes how this robot moves: straight from point to point, and slower if it reacts late. */
  Ride(GlobalVarHolder gvh, MazeTask task) {
    this.gvh = gvh;
    MotionParameters usual = gvh.plat.moat.parameters();
    own = usual.robotType();
    gvh.plat.moat.setParameters(
        DistributedPathPlanning.slowed(
            usual.toBuilder()
                .goalRadiusMm(PASS_MM)
                .smallTurnAngleRad(STRAIGHT_RAD)
                .enableArcing(false)
                .build(),
            STEP_MM));
    gvh.plat.moat.onContact(contacts::add);
    // A robot alone may wander; among others a tube is as wide as a body and its margin.
    boolean isAlone = gvh.id.participants().size() == 1;
    int errorMm = ERROR_MM + (isAlone ? task.mode().wanderMm() : 0);
    TubeSettings tubes = new TubeSettings(errorMm, LEG_MM, 60_000, 200, 2_000, 200, 2_000);
    paths =
        new DistributedPathPlanning(
            gvh, "maze", gvh.id.participants(), new LocalPlanner(), task.floor(), tubes);
    way = new Path(List.of(task.start(), task.start()));
  }

  /** Whether the others know where it stands. */
  boolean isPlaced() {
    return paths.isPlaced();
  }

  /** The tubes of other robots, as far as known. */
  List<Capsule> taken() {
    return paths.taken();
  }

  /** Whether it holds no more than where it stands. */
  boolean isStill() {
    return paths.held().stream().allMatch(tube -> tube.end().equals(tube.points().get(0)));
  }

  /** Half the width of its tubes. */
  double tubeMm() {
    return paths.radiusMm();
  }

  /** The piece of a path that it drives or has driven. */
  Path way() {
    return way;
  }

  /**
   * Asks for a tube along the first piece of a path, and drives in it.
   *
   * @param lastMm the ride ends when the robot is nearer to the end than this
   * @return false if it is not certain enough that the robot is where the path begins
   */
  boolean along(Path path, double lastMm, CollisionMode mode) {
    double endMm = Math.min(PASS_MM, lastMm);
    if (gvh.gps.maxDistanceMm(path.start()) > ERROR_MM + endMm) {
      return false;
    }
    contacts.clear();
    way = firstPiece(path);
    isWhole = way.goal().equals(path.goal());
    gvh.plat.moat.setParameters(
        gvh.plat.moat.parameters().toBuilder()
            .collisionPolicy(mode.policy())
            .robotType(own == RobotType.GOAL ? mode.robotType() : own)
            .goalRadiusMm(endMm)
            .build());
    paths.goAlong(way);
    return true;
  }

  /** Drives on; call it once a period. */
  State step() {
    extendTrail();
    if (!contacts.isEmpty()) {
      return State.BUMPED;
    }
    return switch (paths.tubeflag().get()) {
      case DONE -> isWhole ? State.ARRIVED : State.PART_WAY;
      case MOVING -> State.UNDER_WAY;
      case PLANNING, CLAIMING -> {
        if (paths.inTheWay().isEmpty()) {
          yield State.UNDER_WAY;
        }
        paths.stop();
        yield State.REFUSED;
      }
      case FAIL, IDLE -> State.HELD_UP;
    };
  }

  void stop() {
    extendTrail();
    paths.stop();
  }

  /** The contacts since the start of the ride. */
  List<Contact> contacts() {
    return List.copyOf(contacts);
  }

  /** Whether to try what was found: narrow ways, and none, only so often in a row. */
  boolean mayTry(Search.Outcome found) {
    boolean isWide = found instanceof Search.Outcome.Way wide && !wide.isNarrow();
    lost = isWide ? 0 : lost + 1;
    return lost <= TRIES_WHEN_LOST;
  }

  /**
   * The latest point of its trail that {@code isAllowed}, null if there is none; forgets the trail
   * from there on.
   */
  @Nullable Point retreatTo(Predicate<Point> isAllowed) {
    Point here = gvh.gps.pose().at();
    for (int i = trail.size() - 1; i >= 0; i--) {
      Point at = trail.get(i);
      if (at.distanceMm(here) >= LEAST_RETREAT_MM && isAllowed.test(at)) {
        trail.subList(i + 1, trail.size()).clear();
        return at;
      }
    }
    return null;
  }

  /** A random point of its trail; null if it has none. */
  @Nullable Point somewhereOnTrail(Rng rng) {
    return trail.isEmpty() ? null : trail.get(rng.nextInt(trail.size()));
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

  /** As much of a path as is short enough, and fits one tube. */
  private static Path firstPiece(Path path) {
    List<Point> points = new ArrayList<>(List.of(path.start()));
    double restMm = LONGEST_PIECE_MM;
    int rest = Tube.MAX_POINTS - 1;
    for (int i = 0; i < path.legs() && restMm > 0 && rest > 0; i++) {
      Point from = path.leg(i).from();
      Point to = path.leg(i).to();
      double mm = from.distanceMm(to);
      double partMm = Math.min(mm, Math.min(restMm, (double) rest * LEG_MM));
      points.add(partMm == mm ? to : from.plus(to.minus(from).times(partMm / mm)));
      restMm -= partMm;
      rest -= (int) Math.max(1, StrictMath.ceil(partMm / LEG_MM));
    }
    return new Path(points);
  }
}
