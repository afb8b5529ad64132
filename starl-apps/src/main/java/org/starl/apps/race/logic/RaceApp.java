package org.starl.apps.race.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.GvhCell;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.CollisionPolicy;
import org.starl.motion.Location.Known;
import org.starl.motion.MotionParameters;
import org.starl.random.Rng;

/**
 * One robot in a race. It drives to the first point that it knows of nobody to have won; whoever is
 * there first says so to all, and all stop and take the next one. Who bumps into somebody turns away
 * until nothing is in front and drives on (the motion automaton's {@code USE_COLAVOID}); who comes no
 * nearer that way drives to a place near by, drawn at random, and tries again: robots that get into
 * each other's way again and again do not do so for ever. What lies between two sleeps is one atomic
 * action.
 */
public final class RaceApp extends LogicThread {

  /** Where the program is. */
  public enum Location {
    START,
    PICK,
    RACE,
    MAKE_WAY,
    TELL,
    DONE
  }

  /** {@code source} of this app's trace events. */
  public static final String SOURCE = "app";

  /** Variable: the location. */
  public static final String LOCATION = "location";

  /** Variable: the name of the point that the robot races to; empty if there is none. */
  public static final String POINT = "point";

  /**
   * Action with a point's place and name, this robot's distance from it in mm, that distance's error
   * bound, and the mm from which it may be won.
   */
  public static final String ARRIVE = "arrive";

  /** Who has not acknowledged the winners after so long is taken for dead. */
  public static final long TELL_PATIENCE_MS = 90_000;

  private static final long PERIOD_MS = 100;
  private static final long NS_PER_MS = 1_000_000;
  private static final long NO_PROGRESS_MS = 5_000;
  private static final long MAKE_WAY_MS = 3_000;
  private static final double BACK_RAD = StrictMath.PI / 4;
  private static final double LEAST_BACK_RADII = 4;
  private static final double MOST_BACK_RADII = 8;

  private final List<RacePoint> points;
  private final MotionParameters motion;
  private final Scoreboard board;
  private final RightOfWay way;
  private final Rng rng;
  private final GvhCell<Location> location;
  private final GvhCell<String> racingTo;

  private int point;
  private Patience patience;
  private long sinceNs;

  /**
   * @param xid the race: robots with another one are in another race
   * @param points at least one, in the order in which they are raced to
   */
  public RaceApp(GlobalVarHolder gvh, String xid, List<RacePoint> points) {
    super(gvh);
    this.points = List.copyOf(points);
    motion = gvh.plat.moat.parameters();
    location = gvh.variable(SOURCE, LOCATION, Location.START);
    racingTo = gvh.variable(SOURCE, POINT, "");
    board = new Scoreboard(gvh, xid, points, SOURCE);
    way = new RightOfWay(gvh, xid);
    rng = gvh.plat.entropy.fork("race");
    patience = new Patience(points.get(0), motion.robotRadiusMm());
  }

  /** How a robot of {@code parameters} moves to {@code point}. */
  public static MotionParameters motion(MotionParameters parameters, RacePoint point) {
    return parameters.toBuilder()
        .goalRadiusMm(point.radiusMm())
        .collisionPolicy(CollisionPolicy.USE_COLAVOID)
        .noProgressMs(NO_PROGRESS_MS)
        .build();
  }

  /** Returns the name of each point's winner, in the points' order, and then who may not know. */
  @Override
  public List<Object> callStarL() {
    while (true) {
      switch (location.get()) {
        case START -> {
          if (gvh.gps.hasFix()) {
            location.set(Location.PICK);
          }
        }
        case PICK -> pick();
        case RACE -> race();
        case MAKE_WAY -> makeWay();
        case TELL -> {
          if (board.isConfirmed() || hasLasted(TELL_PATIENCE_MS)) {
            location.set(Location.DONE);
          }
        }
        case DONE -> {
          return results();
        }
      }
      sleep(PERIOD_MS);
    }
  }

  private void pick() {
    gvh.plat.moat.motion_stop();
    point = board.next();
    if (point == points.size()) {
      racingTo.set("");
      enter(Location.TELL);
      return;
    }
    racingTo.set(points.get(point).name());
    patience = new Patience(points.get(point), motion.robotRadiusMm());
    drive();
  }

  private void drive() {
    RacePoint next = points.get(point);
    gvh.plat.moat.setParameters(
        motion(motion, next).toBuilder()
            .collisionTurnMs(rng.nextLong(300, 1200))
            .collisionStraightMs(rng.nextLong(300, 2500))
            .build());
    gvh.plat.moat.doMove(new ItemPosition(next.name(), next.at().xMm(), next.at().yMm()));
    enter(Location.RACE);
  }

  private void race() {
    if (board.isTaken(point)) {
      location.set(Location.PICK);
    } else if (gvh.gps.location() instanceof Known known) {
      double distanceMm = known.pose().distanceMm(points.get(point).at());
      if (distanceMm <= points.get(point).radiusMm() && known.errorMm() <= motion.maxErrorMm()) {
        arrive(0); // also in the midst of turning away from somebody
      } else if (gvh.plat.moat.failed()) {
        inVain(distanceMm);
      } else if (!gvh.plat.moat.inMotion()) {
        drive(); // a fix has shown that it is not quite there
      } else if (way.isOthers(point)) {
        giveWay(distanceMm);
      }
    }
  }

  private void inVain(double distanceMm) {
    if (patience.isEnough(distanceMm)) {
      arrive((int) Math.ceil(distanceMm));
    } else if (way.isOthers(point)) {
      giveWay(distanceMm);
    } else if (way.hasAsked()) {
      drawBack();
    } else {
      way.ask(point, points.get(point).at(), distanceMm);
      drive();
    }
  }

  /** Unless this robot is nearer, and has not had its turn. */
  private void giveWay(double distanceMm) {
    if (way.hasAsked() || !way.isNearer(distanceMm)) {
      drawBack();
    } else {
      way.ask(point, points.get(point).at(), distanceMm);
      if (!gvh.plat.moat.inMotion()) {
        drive();
      }
    }
  }

  private void makeWay() {
    if (board.isTaken(point)) {
      location.set(Location.PICK);
    } else if (!way.isOthers(point) && hasLasted(MAKE_WAY_MS)) {
      drive();
    } else if (gvh.plat.moat.failed()) {
      driveBack();
    }
  }

  private void arrive(int keptOffMm) {
    RacePoint there = points.get(point);
    gvh.trace.action(
        SOURCE,
        ARRIVE,
        point,
        there.name(),
        gvh.gps.pose().distanceMm(there.at()),
        gvh.gps.errorMm(),
        Math.max(there.radiusMm(), keptOffMm));
    board.claim(point, keptOffMm);
    location.set(Location.PICK);
  }

  private void drawBack() {
    driveBack();
    enter(Location.MAKE_WAY);
  }

  /** To a place drawn behind this robot, seen from the point. */
  private void driveBack() {
    Point at = gvh.gps.pose().at();
    double outwards = at.minus(points.get(point).at()).angleRad();
    double angle = outwards + BACK_RAD * (2 * rng.nextDouble() - 1);
    double mm =
        motion.robotRadiusMm()
            * (LEAST_BACK_RADII + (MOST_BACK_RADII - LEAST_BACK_RADII) * rng.nextDouble());
    gvh.plat.moat.doMove(
        new ItemPosition(
            "back", at.xMm() + mm * StrictMath.cos(angle), at.yMm() + mm * StrictMath.sin(angle)));
  }

  private void enter(Location next) {
    location.set(next);
    sinceNs = nowNs();
  }

  private boolean hasLasted(long ms) {
    return nowNs() - sinceNs >= ms * NS_PER_MS;
  }

  private long nowNs() {
    return gvh.plat.clock.nowNs();
  }

  private List<Object> results() {
    List<Object> results = new ArrayList<>();
    board.claims().forEach(claim -> results.add(claim.winner().name()));
    if (!board.isConfirmed()) {
      results.add("not confirmed by " + board.unconfirmed());
    }
    return results;
  }
}
