package org.starl.shape;

import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.geometry.RegionText;

/** The shapes of places on the floor. Lengths are in mm, angles in rad. */
public final class Geometry {

  /** A point. */
  public static final Shape<Point> POINT =
      Shapes.of(
          Point.class, part("xMm", REAL, Point::xMm), part("yMm", REAL, Point::yMm), Point::new);

  /** A pose. */
  public static final Shape<Pose> POSE =
      Shapes.of(
          Pose.class,
          part("xMm", REAL, Pose::xMm),
          part("yMm", REAL, Pose::yMm),
          part("headingRad", REAL, Pose::headingRad),
          Pose::new);

  /** A named pose. */
  public static final Shape<ItemPosition> ITEM =
      Shapes.of(
          ItemPosition.class,
          part("name", TEXT, ItemPosition::name),
          part("pose", POSE, ItemPosition::pose),
          ItemPosition::new);

  /** A region, as {@link RegionText} writes it. */
  public static final Shape<Region> REGION =
      Shapes.text("region", RegionText::format, RegionText::parse);

  private Geometry() {}
}
