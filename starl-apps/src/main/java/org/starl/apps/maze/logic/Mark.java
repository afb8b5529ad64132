package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.motion.Contact;

/**
 * A place that a contact has proven to be blocked. The body's centre was at {@code at}, and an
 * obstacle touches the body between two directions; the exact point is unknown. A body of radius r
 * does not fit around a centre that is nearer than r to the touched point. So it does not fit
 * around a centre that is nearer than r to <em>all</em> points of the arc. The mark is the
 * intersection of the discs around them: a lens that begins just before the contact and covers the
 * obstacle.
 *
 * @param at the centre, by the robot's own position
 * @param errorMm the true centre was within this distance
 * @param fromRad the first direction of the contact, the error of the heading included
 * @param sweepRad to the last one, counter-clockwise, below pi
 * @param bodyMm radius of the body
 */
public record Mark(Point at, double errorMm, double fromRad, double sweepRad, double bodyMm) {

  // Gap at which a bump sensor already closes.
  private static final double TOUCH_MM = 2;

  // Corners are whole mm, and points of the arc are taken every few degrees.
  private static final double ROUNDING_MM = 3;

  // A bump sensor covers its side from straight ahead on, and this much beyond both ends.
  private static final double OTHER_SIDE_RAD = Angles.fromDegrees(18);
  private static final double SIDE_RAD = Angles.fromDegrees(93);

  // If the other sensor is open, the contact is farther to the side than this.
  private static final double OFF_CENTER_RAD = Angles.fromDegrees(12);

  private static final double STEP_RAD = Angles.fromDegrees(5);
  private static final int CORNERS = 20;
  private static final double LEAST_HALF_WIDTH_MM = 8;

  /** One mark for each closed sensor; none if the position is too uncertain. */
  public static List<Mark> of(Contact contact, double bodyMm) {
    List<Mark> marks = new ArrayList<>();
    Bumps bumps = contact.bumps();
    double innerRad = bumps == Bumps.BOTH ? -OTHER_SIDE_RAD : OFF_CENTER_RAD;
    if (bumps != Bumps.RIGHT) {
      add(marks, contact, innerRad, SIDE_RAD, bodyMm);
    }
    if (bumps != Bumps.LEFT) {
      add(marks, contact, -SIDE_RAD, -innerRad, bodyMm);
    }
    return marks;
  }

  /** The places of all {@code marks} that exclude something. */
  static List<Polygon> places(List<Mark> marks, double part) {
    List<Polygon> places = new ArrayList<>();
    for (Mark mark : marks) {
      Polygon place = mark.place(part);
      if (place != null) {
        places.add(place);
      }
    }
    return places;
  }

  private static void add(
      List<Mark> marks, Contact contact, double from, double to, double bodyMm) {
    double errorRad = contact.at().errorRad();
    double sweepRad = to - from + 2 * errorRad;
    if (sweepRad < StrictMath.PI) {
      double first = contact.at().pose().headingRad() + from - errorRad;
      Mark mark =
          new Mark(contact.at().pose().at(), contact.at().errorMm(), first, sweepRad, bodyMm);
      // Otherwise the robot would come back to the same place for ever and learn nothing.
      if (mark.radiusMm(1) > bodyMm) {
        marks.add(mark);
      }
    }
  }

  /**
   * The area that the centre of a body cannot enter.
   *
   * @param part the body is wider by this part of the margin: 1 for all of it, 0 for the robot's
   *     body
   * @return null if the contact excludes nothing for such a body
   */
  public @Nullable Polygon place(double part) {
    double radiusMm = radiusMm(part);
    double halfRad = sweepRad / 2;
    if (radiusMm - bodyMm * StrictMath.sin(halfRad) < LEAST_HALF_WIDTH_MM) {
      return null;
    }
    List<Point> touching = touching();
    Point middle = toward(at, fromRad + halfRad, bodyMm * StrictMath.cos(halfRad));
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < CORNERS; i++) {
      double directionRad = 2 * StrictMath.PI * i / CORNERS;
      double reachMm = Double.POSITIVE_INFINITY;
      for (Point point : touching) {
        reachMm = Math.min(reachMm, toEdgeMm(middle, directionRad, point, radiusMm));
      }
      Point exact = toward(middle, directionRad, reachMm);
      Point corner = new Point(StrictMath.rint(exact.xMm()), StrictMath.rint(exact.yMm()));
      if (corners.isEmpty() || !corners.get(corners.size() - 1).equals(corner)) {
        corners.add(corner);
      }
    }
    return new Polygon(corners);
  }

  /** Radius of the discs: the body's, less all errors of the touched point. */
  private double radiusMm(double part) {
    return bodyMm + part * MazeTask.MARGIN_MM - TOUCH_MM - errorMm - ROUNDING_MM;
  }

  /** Points of the arc, one of which is near the touched point. */
  private List<Point> touching() {
    int steps = (int) StrictMath.ceil(sweepRad / STEP_RAD);
    List<Point> touching = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      touching.add(toward(at, fromRad + sweepRad * i / steps, bodyMm));
    }
    return touching;
  }

  private static Point toward(Point from, double directionRad, double mm) {
    return new Point(
        from.xMm() + mm * StrictMath.cos(directionRad),
        from.yMm() + mm * StrictMath.sin(directionRad));
  }

  /** Distance from a point inside a circle to its edge. */
  private static double toEdgeMm(Point from, double directionRad, Point center, double radiusMm) {
    Point off = from.minus(center);
    double along =
        off.xMm() * StrictMath.cos(directionRad) + off.yMm() * StrictMath.sin(directionRad);
    return -along + StrictMath.sqrt(along * along - off.dot(off) + radiusMm * radiusMm);
  }
}
