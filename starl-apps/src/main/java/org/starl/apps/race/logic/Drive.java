package org.starl.apps.race.logic;

import org.starl.GlobalVarHolder;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.motion.Location.Known;
import org.starl.random.Rng;

/**
 * How a robot drives in a race: to a point, turning away from whom it bumps into for a time drawn at
 * random; or back from it, to a place near by that is drawn at random too. Robots that get into each
 * other's way again and again do not do so for ever. Strand only.
 */
public final class Drive {

  private static final long NO_PROGRESS_MS = 5_000;
  private static final double BACK_RAD = StrictMath.PI / 4;
  private static final double LEAST_BACK_RADII = 4;
  private static final double MOST_BACK_RADII = 8;

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

  /** To a place drawn behind this robot, seen from {@code point}. */
  void backFrom(RacePoint point) {
    Point at = gvh.gps.pose().at();
    double outwards = at.minus(point.at()).angleRad();
    double angle = outwards + BACK_RAD * (2 * rng.nextDouble() - 1);
    double mm =
        usual.robotRadiusMm()
            * (LEAST_BACK_RADII + (MOST_BACK_RADII - LEAST_BACK_RADII) * rng.nextDouble());
    gvh.plat.moat.doMove(
        new ItemPosition(
            "back", at.xMm() + mm * StrictMath.cos(angle), at.yMm() + mm * StrictMath.sin(angle)));
  }

  /** Whether a robot that is {@code known} to be somewhere is at {@code point}. */
  boolean isAt(RacePoint point, Known known) {
    return known.pose().distanceMm(point.at()) <= point.radiusMm()
        && known.errorMm() <= usual.maxErrorMm();
  }
}
