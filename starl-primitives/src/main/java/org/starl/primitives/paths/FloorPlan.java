package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.CoordinateArrays;
import org.locationtech.jts.geom.Envelope;
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
 * Computes the free space of a task: all obstacles, widened by the margin, as polygons with corners
 * in whole mm. JTS buffers and unites them; its last bits may differ between JVMs, and the rounding
 * removes this difference.
 */
final class FloorPlan {

  private static final int QUADRANT_SEGMENTS = 8;

  /**
   * JTS approximates a round corner by chords of the circle. With a radius larger by this factor
   * the chords stay outside the intended circle.
   */
  private static final double CHORD_FACTOR =
      1 / StrictMath.cos(StrictMath.PI / (4 * QUADRANT_SEGMENTS));

  /** Covers the rounding of input and corners, and the shift of lines noded on the grid. */
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
    // Adjacent bodies, as in a grid map, are united before they are widened: this saves most work.
    solid.add(plan.union(bodies));
    Geometry known = plan.widen(solid, task.marginMm());
    List<Geometry> more = new ArrayList<>();
    // Those of one width are widened, and so united, together: on the grid that takes much longer.
    SortedMap<Double, List<Geometry>> axes = new TreeMap<>();
    for (Capsule capsule : task.taken()) {
      axes.computeIfAbsent(capsule.radiusMm(), any -> new ArrayList<>())
          .add(axis(capsule.axis(), plan.factory));
    }
    axes.forEach((radiusMm, all) -> more.add(plan.widen(all, task.marginMm() + radiusMm)));
    for (org.starl.geometry.Polygon place : task.keepOut()) {
      more.add(valid(plan.factory.createPolygon(outline(place.vertices(), true))));
    }
    more.add(plan.frame(task));
    // The many small parts are united first, so that the large one is processed only once.
    Geometry whole = OverlayNG.overlay(known, plan.union(more), OverlayNG.UNION, WHOLE_MM);
    whole.normalize();
    List<Coordinate[]> rings = new ArrayList<>();
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

  /** The union, with all corners in whole mm. */
  private Geometry union(List<Geometry> parts) {
    return UnaryUnionNG.union(factory.buildGeometry(parts), WHOLE_MM);
  }

  private Geometry widen(List<Geometry> solid, double marginMm) {
    BufferParameters parameters = new BufferParameters(QUADRANT_SEGMENTS);
    parameters.setSimplifyFactor(0);
    double distanceMm = (marginMm + ROUNDING_MM) * CHORD_FACTOR;
    return BufferOp.bufferOp(factory.buildGeometry(solid), distanceMm, parameters);
  }

  // An outline that crosses itself is also added as a line, so that paths avoid all of it.
  private void add(Obstacle obstacle, List<Geometry> bodies, List<Geometry> lines) {
    Coordinate[] outline = outline(obstacle.points(), obstacle.closed());
    Polygon body = obstacle.closed() ? factory.createPolygon(outline) : factory.createPolygon();
    if (!body.isEmpty()) {
      bodies.add(valid(body));
    }
    if (!body.isValid() || !obstacle.closed()) {
      lines.add(factory.createLineString(outline));
    }
  }

  private static Coordinate[] outline(List<Point> points, boolean closed) {
    int count = points.size();
    Coordinate[] outline = new Coordinate[closed ? count + 1 : count];
    for (int i = 0; i < outline.length; i++) {
      outline[i] = coordinate(points.get(i % count));
    }
    return outline;
  }

  private static Geometry valid(Polygon body) {
    return body.isValid() ? body : GeometryFixer.fix(body);
  }

  /**
   * A thin frame around the floor. Obstacles at the border unite with it, so that each connected
   * part of the free space is a hole of a polygon.
   */
  private Geometry frame(PlanTask task) {
    Rectangle inner = FreeSpace.inner(task.bounds(), task.marginMm());
    if (inner == null) {
      return factory.createPolygon();
    }
    return factory.createPolygon(ring(inner, FRAME_MM), new LinearRing[] {ring(inner, 0)});
  }

  private LinearRing ring(Rectangle inner, double outwardsMm) {
    Envelope box = new Envelope(inner.xMinMm(), inner.xMaxMm(), inner.yMinMm(), inner.yMaxMm());
    box.expandBy(outwardsMm);
    return ((Polygon) factory.toGeometry(box)).getExteriorRing();
  }

  /** A segment with its ends in whole mm; a point if they are equal. */
  static Geometry axis(Segment segment, GeometryFactory factory) {
    Coordinate from = coordinate(segment.from());
    Coordinate to = coordinate(segment.to());
    return from.equals2D(to)
        ? factory.createPoint(from)
        : factory.createLineString(new Coordinate[] {from, to});
  }

  private static Coordinate coordinate(Point point) {
    return new Coordinate(FreeSpace.whole(point.xMm()), FreeSpace.whole(point.yMm()));
  }

  private static void addRings(Polygon polygon, List<Coordinate[]> rings) {
    rings.add(ring(polygon.getExteriorRing(), true));
    for (int i = 0; i < polygon.getNumInteriorRing(); i++) {
      rings.add(ring(polygon.getInteriorRingN(i), false));
    }
  }

  /** The corners in the order that has the solid side on the left. */
  private static Coordinate[] ring(LinearRing ring, boolean shell) {
    Coordinate[] corners = ring.getCoordinates().clone();
    if (Orientation.isCCW(corners) != shell) {
      CoordinateArrays.reverse(corners);
    }
    return corners;
  }
}
