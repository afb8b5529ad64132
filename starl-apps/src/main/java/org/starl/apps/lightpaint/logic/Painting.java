package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeSettings;

/**
 * What all painters know from the start.
 *
 * @param strokes the drawing, each stroke at the index that is its number
 * @param floor all bodies stay inside
 */
public record Painting(List<Stroke> strokes, Rectangle floor) {

  /** Painters drive slowly and know their positions well: narrow tubes, short deadlines. */
  static final TubeSettings TUBES = new TubeSettings(40, 1_000, 10_000, 200, 2_000, 200, 2_000);

  private static final double GOAL_RADIUS_MM = 8;

  public Painting {
    strokes = List.copyOf(strokes);
  }

  /** Motion parameters of a painter with this body: exact, but slower. */
  public static MotionParameters motion(MotionParameters body) {
    return body.toBuilder()
        .goalRadiusMm(GOAL_RADIUS_MM)
        .smallTurnAngleRad(Angles.fromDegrees(1))
        .turnSpeedMinRadPerS(Angles.fromDegrees(12))
        .linSpeedMinMmPerS(100)
        .slowFwdRadiusMm(150)
        .enableArcing(false)
        .build();
  }

  /** Half the width of a painter's tube. */
  public static int radiusMm(MotionParameters body) {
    return DistributedPathPlanning.radiusMm(motion(body), TUBES);
  }

  /** Maximum distance of a body in its tube from the line that it follows. */
  public static double trackMm(MotionParameters body) {
    return radiusMm(body) - body.robotRadiusMm();
  }
}
