package org.starl.apps.race.logic;

import org.starl.GlobalVarHolder;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.Location.Known;
import org.starl.random.Rng;

/**
 * Drives a robot to a point, turning away from robots that it bumps into, or back from the point.
 * How long it turns away and where it drives back to is random, so that two robots do not get into
 * each other's way for ever. Strand only.
 */
public final class Drive {

  /** The name of places to which robots draw back. */
  public static final String BACK = "back";

  private static final long NO_PROGRESS_MS = 5_000;
  private static final double BACK_RAD = StrictMath.PI / 4;
  private static final double MIN_BACK_RADII = 4;
  private static final double MAX_BACK_RADII = 8;

  private final GlobalVarHolder gvh;
  private final MotionParameters usual;
  private final Rng rng;

  Drive(GlobalVarHolder gvh) {
    this.gvh = gvh;
    usual = gvh.plat.moat.parameters();
    rng = gvh.plat.entropy.fork("race");
  }

  /** How a robot of {@code parameters} moves to {@code point}. */
  public static MotionParameters motion(MotionParameters parameters, RacePoint point) {
    return parameters.toBuilder()
        .goalRadiusMm(point.radiusMm())
        .collisionPolicy(CollisionPolicy.USE_COLAVOID)
        .noProgressMs(NO_PROGRESS_MS)
        .build();
  }

  void to(RacePoint point) {
    gvh.plat.moat.setParameters(
        motion(usual, point).toBuilder()
            .collisionTurnMs(rng.nextLong(300, 1200))
            .collisionStraightMs(rng.nextLong(300, 2500))
            .build());
    gvh.plat.moat.doMove(new ItemPosition(point.name(), point.at().xMm(), point.at().yMm()));
  }

  /** Drives to a random place behind this robot, as seen from {@code point}. */
  void backFrom(RacePoint point) {
    Point at = gvh.gps.pose().at();
    double angle = at.minus(point.at()).angleRad() + BACK_RAD * (2 * rng.nextDouble() - 1);
    double radii = MIN_BACK_RADII + (MAX_BACK_RADII - MIN_BACK_RADII) * rng.nextDouble();
    double mm = usual.robotRadiusMm() * radii;
    Point back = at.plus(new Point(mm * StrictMath.cos(angle), mm * StrictMath.sin(angle)));
    gvh.plat.moat.doMove(new ItemPosition(BACK, back.xMm(), back.yMm()));
  }

  /** Whether a robot with this fix is at {@code point}. */
  boolean isAt(RacePoint point, Known known) {
    return known.pose().distanceMm(point.at()) <= point.radiusMm()
        && known.errorMm() <= usual.maxErrorMm();
  }
}
