package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.TubeSettings;

/**
 * What all painters know from the start. The floor is the drawing's bounding box and a margin
 * around it, in which every painter has a home. The homes are evenly spread on a ring, or on
 * several rings.
 *
 * @param strokes the drawing, each stroke at the index that is its number
 * @param floor all bodies stay inside
 * @param homes one for each painter; a painter there is in the way of no tube along the drawing
 */
public record Painting(List<Stroke> strokes, Rectangle floor, List<Point> homes) {

  /** Painters drive slowly and know their positions well: narrow tubes, short deadlines. */
  static final TubeSettings TUBES = new TubeSettings(40, 1_000, 10_000, 200, 2_000, 200, 2_000);

  private static final double SPARE_MM = 30;

  /** With homes that are farther from the drawing, no tube reaches all strokes. */
  private static final double FAR_MM = 10_000;

  /** Slower painters with narrower tubes can work nearer to each other. */
  private static final double STEP_MM = 80;

  public Painting {
    strokes = List.copyOf(strokes);
    homes = List.copyOf(homes);
  }

  /**
   * @param starts where painters start, if not at home: on the floor as well
   * @param radiusMm half the width of a tube
   */
  public static Painting of(
      List<Stroke> strokes, List<Point> starts, int painters, double radiusMm) {
    List<Point> points = new ArrayList<>(starts);
    strokes.forEach(stroke -> points.addAll(stroke.path().points()));
    Rectangle drawing = Rectangle.around(points);
    // A tube may run along the border of the drawing while other painters are at home.
    double apartMm = 2 * radiusMm + SPARE_MM;
    double marginMm = apartMm;
    // Two homes on both sides of a corner are nearer to each other than along the border.
    double alongMm = apartMm * StrictMath.sqrt(2);
    while (border(drawing.widened(marginMm)).lengthMm() < painters * alongMm) {
      marginMm += apartMm;
    }
    List<Point> homes = new ArrayList<>();
    if (marginMm <= FAR_MM) {
      spread(painters, border(drawing.widened(marginMm)), homes);
    } else {
      // Several rings, with room for a tube between two homes and between two rings.
      double aisleMm = 2 * apartMm;
      marginMm = apartMm - aisleMm;
      while (homes.size() < painters) {
        marginMm += aisleMm;
        Polyline ring = border(drawing.widened(marginMm));
        int room = (int) (ring.lengthMm() / aisleMm);
        spread(Math.min(room, painters - homes.size()), ring, homes);
      }
    }
    return new Painting(strokes, drawing.widened(marginMm + radiusMm + SPARE_MM), homes);
  }

  private static void spread(int count, Polyline border, List<Point> homes) {
    for (int i = 0; i < count; i++) {
      homes.add(Polyline.rounded(border.at(border.lengthMm() / count * (i + 0.5))));
    }
  }

  /** From the lower left corner counter-clockwise. */
  private static Polyline border(Rectangle box) {
    Point start = new Point(box.xMinMm(), box.yMinMm());
    Point opposite = new Point(box.xMaxMm(), box.yMaxMm());
    Point right = new Point(opposite.xMm(), start.yMm());
    Point top = new Point(start.xMm(), opposite.yMm());
    return new Polyline(List.of(start, right, opposite, top, start));
  }

  /** Motion parameters of a painter with this body: exact, but slower. */
  public static MotionParameters motion(MotionParameters body) {
    return DistributedPathPlanning.slowed(
        body.toBuilder()
            .goalRadiusMm(8)
            .smallTurnAngleRad(Angles.fromDegrees(1))
            .turnSpeedMinRadPerS(Angles.fromDegrees(12))
            .linSpeedMinMmPerS(100)
            .slowTurnAngleRad(Angles.fromDegrees(8))
            .slowFwdRadiusMm(50)
            .enableArcing(false)
            .build(),
        STEP_MM);
  }

  /** Half the width of a painter's tube. */
  public static int radiusMm(MotionParameters body) {
    return DistributedPathPlanning.radiusMm(motion(body), TUBES, STEP_MM);
  }

  /** Maximum distance of a body in its tube from the line that it follows. */
  public static double trackMm(MotionParameters body) {
    return radiusMm(body) - body.robotRadiusMm();
  }
}
