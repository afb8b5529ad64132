package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.starl.body.MotionParameters;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Region;
import org.starl.geometry.Segment;
import org.starl.geometry.Union;

/** Computes tubes for a robot with tracking errors, and the walls that keep it inside. */
final class Tracking {

  private static final int QUADRANT_SEGMENTS = 8;
  private static final double WALL_MM = 20;
  private static final double ROUNDING_MM = 2;

  // A wall's corners are rounded to whole mm, and no wall may lie outside of its part.
  private static final double CORNER_MM = 1;

  private static final double MS_PER_S = 1e3;

  private Tracking() {}

  /**
   * The sum of the body's radius, the position error, the goal radius at the leg's start, the
   * deviation from the leg, and the distance driven in one control step. A robot whose heading
   * differs from the direction of the leg's end by at most the angle a stays inside a logarithmic
   * spiral. The spiral deviates from a straight leg of length L by at most {@code L sin(a) exp(-a /
   * tan(a))}.
   */
  static int tubeRadiusMm(MotionParameters p, TubeSettings settings) {
    return tubeRadiusMm(p, settings, p.linSpeedMaxMmPerS() * stepS(p));
  }

  /** The same for a robot that drives at most {@code stepMm} in one control step. */
  static int tubeRadiusMm(MotionParameters p, TubeSettings settings, double stepMm) {
    double offRad =
        p.smallTurnAngleRad() + p.turnSpeedMinRadPerS() * p.automatonPeriodMs() / MS_PER_S;
    double strayMm =
        settings.maxLegMm()
            * StrictMath.sin(offRad)
            * StrictMath.exp(-offRad / StrictMath.tan(offRad));
    double sumMm =
        p.robotRadiusMm() + settings.positionErrorMm() + p.goalRadiusMm() + strayMm + stepMm;
    // The wall consists of chords, which lie inside the circle.
    double chordFactor = StrictMath.cos(StrictMath.PI / (4 * QUADRANT_SEGMENTS));
    return (int) StrictMath.ceil((sumMm + ROUNDING_MM) / chordFactor);
  }

  /** The longest effect of one control step, in seconds at the commanded speed. */
  static double stepS(MotionParameters p) {
    return (1 + p.speedError()) * (p.automatonPeriodMs() + 2 * p.reactionMs()) / MS_PER_S;
  }

  /** Motion parameters for driving along a tube: straight to each point, without arcs. */
  static MotionParameters straight(MotionParameters p) {
    return p.toBuilder().enableArcing(false).stopAtDestination(true).build();
  }

  /**
   * The border of a part, as the region to avoid of {@code do_move(t, A)}. A body that starts
   * inside and never touches it stays inside.
   */
  static Region wall(Capsule part) {
    Geometry axis = FloorPlan.axis(part.axis(), new GeometryFactory());
    Point inside = part.axis().from();
    List<Point> outline = new ArrayList<>();
    double insideMm = part.radiusMm() - CORNER_MM;
    for (Coordinate corner : axis.buffer(insideMm, QUADRANT_SEGMENTS).getCoordinates()) {
      Point point = Tube.rounded(new Point(corner.x, corner.y));
      if (outline.isEmpty() || !outline.get(outline.size() - 1).equals(point)) {
        outline.add(point);
      }
    }
    List<Region> wall = new ArrayList<>();
    for (int i = 1; i < outline.size(); i++) {
      wall.add(brick(outline.get(i - 1), outline.get(i), inside));
    }
    return new Union(wall);
  }

  /** A triangle on the outer side of a chord of a convex outline. */
  private static Region brick(Point a, Point b, Point inside) {
    Point along = b.minus(a);
    Point normal = new Point(-along.yMm(), along.xMm()).times(WALL_MM / along.normMm());
    boolean pointsInside = normal.dot(inside.minus(a)) > 0;
    Point outwards = pointsInside ? normal.times(-1) : normal;
    return Polygon.of(a, b, a.plus(along.times(0.5)).plus(outwards));
  }

  /** A tube along {@code path} with legs of at most {@code maxLegMm}; null if it has too many. */
  static @Nullable Tube tube(Path path, int radiusMm, int maxLegMm) {
    List<Point> points = new ArrayList<>();
    points.add(Tube.rounded(path.start()));
    for (int i = 0; i < path.legs(); i++) {
      Segment leg = path.leg(i);
      double lengthMm = leg.from().distanceMm(leg.to());
      int pieces = (int) Math.max(1, StrictMath.ceil(lengthMm / maxLegMm));
      if (points.size() + pieces > Tube.MAX_POINTS) {
        return null;
      }
      for (int j = 1; j <= pieces; j++) {
        Point cut = leg.from().plus(leg.to().minus(leg.from()).times((double) j / pieces));
        points.add(Tube.rounded(cut));
      }
    }
    return new Tube(points, radiusMm);
  }
}
