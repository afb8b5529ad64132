package org.starl.apps.search.logic;

import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeSettings;

/** How searchers drive: their motion, the tubes of a house, and what room they need. */
public final class Driving {

  private static final double GOAL_RADIUS_MM = 10;

  /** No way through a house is longer than so many times its width and height together. */
  private static final double WAY = 1;

  /** A way has corners, too. */
  private static final int SPARE_POINTS = 12;

  /** Most ways are within a room. */
  private static final double FIRST_LOOK_MM = 1_000;

  private static final double PLANNERS_CHORDS = 1.005;
  private static final double PLANNERS_ROUNDING_MM = 4;

  private Driving() {}

  /**
   * The paths of one robot of a search, whose body moves from now on as searchers do.
   *
   * @param xid names the search
   */
  static DistributedPathPlanning paths(GlobalVarHolder gvh, String xid, Rectangle bounds) {
    gvh.plat.moat.setParameters(motion(gvh.plat.moat.parameters()));
    return new DistributedPathPlanning(
        gvh,
        xid,
        gvh.id.participants(),
        new StraightFirst(new FewerCorners(new LocalPlanner(FIRST_LOOK_MM))),
        bounds,
        tubes(bounds));
  }

  /**
   * Tubes of a house: its longest ways fit one tube, of {@link Tube#MAX_POINTS}. The shorter their
   * parts are the narrower they can be; of up to a metre, robots may start 500 mm apart.
   */
  public static TubeSettings tubes(Rectangle bounds) {
    double longestMm =
        WAY * (bounds.xMaxMm() - bounds.xMinMm() + bounds.yMaxMm() - bounds.yMinMm());
    int legMm = (int) StrictMath.ceil(longestMm / (Tube.MAX_POINTS - SPARE_POINTS));
    return new TubeSettings(20, Math.max(1_000, legMm), 120_000, 200, 2_000, 500, 4_000);
  }

  /** How searchers move whose bodies are like that. */
  public static MotionParameters motion(MotionParameters body) {
    return body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build();
  }

  /**
   * How far from every wall such a searcher's centre stays: its tube's radius, what its planner spends
   * on fewer corners, and rounding.
   */
  public static double clearanceMm(MotionParameters body, Rectangle bounds) {
    double radiusMm = DistributedPathPlanning.radiusMm(motion(body), tubes(bounds));
    return (radiusMm + FewerCorners.SPARE_MM) * PLANNERS_CHORDS + PLANNERS_ROUNDING_MM;
  }
}
