package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.PrecisionModel;
import org.locationtech.jts.geom.util.GeometryFixer;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.UnaryUnionNG;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * Makes the free space of a task: what is in the way, wider by the margin, as polygons with corners
 * on whole millimetres. JTS widens and joins; its last bits, which may differ from one JVM to the
 * next, are gone after the rounding.
 */
final class FloorPlan {

  private static final int QUADRANT_SEGMENTS = 8;

  /**
   * JTS draws a round corner as chords, from points on the circle. With a radius larger by this factor
   * the chords stay outside the circle that is meant.
   */
  private static final double CHORD_FACTOR =
      1 / StrictMath.cos(StrictMath.PI / (4 * QUADRANT_SEGMENTS));

  /** Rounding of the input, of the corners, and what lines move when they are noded on the grid. */
  private static final double ROUNDING_MM = 2.5;

  private static final double FRAME_MM = 10;

  private static final PrecisionModel WHOLE_MM = new PrecisionModel(1);

  private final GeometryFactory factory = new GeometryFactory();

  private FloorPlan() {}

  static FreeSpace of(PlanTask task) {
    FloorPlan plan = new FloorPlan();
    List<Geometry> bodies = new ArrayList<>();
    List<Geometry> solid = new ArrayList<>();
    for (Obstacle obstacle : task.obstacles().all()) {
      plan.add(obstacle, bodies, solid);
    }
    // Bodies side by side, as in a grid map, are one before they are widened: that saves most work.
    solid.add(plan.union(bodies));
    Geometry known = plan.widen(solid, task.marginMm());
    List<Geometry> more = new ArrayList<>();
    for (Capsule capsule : task.taken()) {
      more.add(plan.widen(List.of(plan.line(capsule.axis())), marginMm(task, capsule)));
    }
    for (org.starl.geometry.Polygon place : task.keepOut()) {
      more.add(plan.asItIs(place));
    }
    more.add(plan.frame(task));
    // What is known is large, the others are small and many: joined first, they meet it but once.
    Geometry whole = OverlayNG.overlay(known, plan.union(more), OverlayNG.UNION, WHOLE_MM);
    whole.normalize();
    List<int[][]> rings = new ArrayList<>();
    for (int i = 0; i < whole.getNumGeometries(); i++) {
      if (!(whole.getGeometryN(i) instanceof Polygon polygon)) {
        throw new IllegalStateException("widened to " + whole.getGeometryN(i).getGeometryType());
      }
      if (!polygon.isEmpty()) {
        addRings(polygon, rings);
      }
    }
    return new FreeSpace(rings, task.bounds(), task.marginMm());
  }

  /** Joined, with all corners on whole millimetres. */
  private Geometry union(List<Geometry> parts) {
    return UnaryUnionNG.union(factory.buildGeometry(parts), WHOLE_MM);
  }

  private static double marginMm(PlanTask task, Capsule taken) {
    return task.marginMm() + taken.radiusMm();
  }

  private Geometry widen(List<Geometry> solid, double marginMm) {
    BufferParameters parameters = new BufferParameters(QUADRANT_SEGMENTS);
    parameters.setSimplifyFactor(0);
    double distanceMm = (marginMm + ROUNDING_MM) * CHORD_FACTOR;
    return BufferOp.bufferOp(factory.buildGeometry(solid), distanceMm, parameters);
  }

  // The border goes with an outline that crosses itself: all of it is kept away from.
  private void add(Obstacle obstacle, List<Geometry> bodies, List<Geometry> lines) {
    List<Point> points = obstacle.points();
    int count = points.size();
    Coordinate[] outline = new Coordinate[obstacle.closed() ? count + 1 : count];
    for (int i = 0; i < outline.length; i++) {
      outline[i] = coordinate(points.get(i % count));
    }
    Polygon body = obstacle.closed() ? factory.createPolygon(outline) : factory.createPolygon();
    if (!body.isEmpty()) {
      bodies.add(body.isValid() ? body : GeometryFixer.fix(body));
    }
    if (!body.isValid() || !obstacle.closed()) {
      lines.add(factory.createLineString(outline));
    }
  }

  private Geometry asItIs(org.starl.geometry.Polygon place) {
    List<Point> points = place.vertices();
    Coordinate[] outline = new Coordinate[points.size() + 1];
    for (int i = 0; i < outline.length; i++) {
      outline[i] = coordinate(points.get(i % points.size()));
    }
    Polygon body = factory.createPolygon(outline);
    return body.isValid() ? body : GeometryFixer.fix(body);
  }

  /**
   * All that is off the floor, as a thin frame around it: what reaches it is one body with it, so that
   * each room of the free space is one hole.
   */
  private Geometry frame(PlanTask task) {
    Rectangle inner = FreeSpace.inner(task.bounds(), task.marginMm());
    if (inner == null) {
      return factory.createPolygon();
    }
    return factory.createPolygon(ring(inner, FRAME_MM), new LinearRing[] {ring(inner, 0)});
  }

  private LinearRing ring(Rectangle inner, double outwardsMm) {
    double xMin = inner.xMinMm() - outwardsMm;
    double yMin = inner.yMinMm() - outwardsMm;
    double xMax = inner.xMaxMm() + outwardsMm;
    double yMax = inner.yMaxMm() + outwardsMm;
    return factory.createLinearRing(
        new Coordinate[] {
          new Coordinate(xMin, yMin),
          new Coordinate(xMax, yMin),
          new Coordinate(xMax, yMax),
          new Coordinate(xMin, yMax),
          new Coordinate(xMin, yMin)
        });
  }

  private Geometry line(Segment axis) {
    Coordinate from = coordinate(axis.from());
    Coordinate to = coordinate(axis.to());
    return from.equals2D(to)
        ? factory.createPoint(from)
        : factory.createLineString(new Coordinate[] {from, to});
  }

  private static Coordinate coordinate(Point point) {
    return new Coordinate(FreeSpace.whole(point.xMm()), FreeSpace.whole(point.yMm()));
  }

  private static void addRings(Polygon polygon, List<int[][]> rings) {
    rings.add(ring(polygon.getExteriorRing(), true));
    for (int i = 0; i < polygon.getNumInteriorRing(); i++) {
      rings.add(ring(polygon.getInteriorRingN(i), false));
    }
  }

  /** The corners, x and y, in the sense that has the solid side to the left. */
  private static int[][] ring(LinearRing ring, boolean shell) {
    Coordinate[] corners = ring.getCoordinates();
    int count = corners.length - 1;
    boolean forward = Orientation.isCCW(corners) == shell;
    int[][] xy = new int[2][count];
    for (int i = 0; i < count; i++) {
      Coordinate corner = corners[forward ? i : count - i];
      xy[0][i] = FreeSpace.whole(corner.x);
      xy[1][i] = FreeSpace.whole(corner.y);
    }
    return xy;
  }
}
