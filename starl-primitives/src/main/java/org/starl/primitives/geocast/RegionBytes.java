package org.starl.primitives.geocast;

import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/**
 * Regions in messages: a tag of one byte, then coordinates in mm as doubles; before them, polygons
 * and unions have the number of vertices or parts in two bytes. A polygon of about 80 vertices fits
 * a datagram.
 */
public final class RegionBytes {

  /** Their shape: these bytes, and in JSON their text. */
  public static final Shape<Region> SHAPE =
      Geometry.REGION.bytes(RegionBytes::write, RegionBytes::read);

  private static final int NOWHERE = 0;
  private static final int EVERYWHERE = 1;
  private static final int CIRCLE = 2;
  private static final int RECTANGLE = 3;
  private static final int POLYGON = 4;
  private static final int UNION = 5;

  private RegionBytes() {}

  private static void write(Region region, WireWriter out) {
    switch (region) {
      case Nowhere nowhere -> out.u8(NOWHERE);
      case Everywhere everywhere -> out.u8(EVERYWHERE);
      case Circle circle -> {
        out.u8(CIRCLE);
        point(circle.center(), out);
        out.f64(circle.radiusMm());
      }
      case Rectangle rectangle -> {
        out.u8(RECTANGLE);
        out.f64(rectangle.xMinMm());
        out.f64(rectangle.yMinMm());
        out.f64(rectangle.xMaxMm());
        out.f64(rectangle.yMaxMm());
      }
      case Polygon polygon -> {
        out.u8(POLYGON);
        out.u16(polygon.vertices().size());
        for (Point vertex : polygon.vertices()) {
          point(vertex, out);
        }
      }
      case Union union -> {
        out.u8(UNION);
        out.u16(union.parts().size());
        for (Region part : union.parts()) {
          write(part, out);
        }
      }
    }
  }

  private static Region read(WireReader in) {
    try {
      return readAny(in);
    } catch (IllegalArgumentException e) {
      throw new WireFormatException("region: " + e.getMessage());
    }
  }

  // Each part of a union has at least one byte, so the datagram's length bounds the recursion.
  private static Region readAny(WireReader in) {
    int tag = in.u8();
    return switch (tag) {
      case NOWHERE -> new Nowhere();
      case EVERYWHERE -> new Everywhere();
      case CIRCLE -> new Circle(point(in), in.f64());
      case RECTANGLE -> new Rectangle(in.f64(), in.f64(), in.f64(), in.f64());
      case POLYGON -> new Polygon(in.list(in.u16(), RegionBytes::point));
      case UNION -> new Union(in.list(in.u16(), RegionBytes::readAny));
      default -> throw new WireFormatException("region of kind " + tag);
    };
  }

  private static void point(Point point, WireWriter out) {
    out.f64(point.xMm());
    out.f64(point.yMm());
  }

  private static Point point(WireReader in) {
    return new Point(in.f64(), in.f64());
  }
}
