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
 * What a contact proves. The body's centre stood at {@code at}, and something touches the body
 * somewhere between two directions, nobody knows where. Wherever that is, a body of radius r does not
 * fit around any centre that is nearer than r to <em>all</em> of these points. So the mark is what
 * the discs around them have in common: a lens that begins just before the contact and lies over the
 * obstacle.
 *
 * @param at the centre, by the robot's own position
 * @param errorMm the true centre was within this distance
 * @param fromRad the first direction of the contact, the error of the heading included
 * @param sweepRad to the last one, counter-clockwise, below pi
 * @param bodyMm radius of the body
 */
public record Mark(Point at, double errorMm, double fromRad, double sweepRad, double bodyMm) {

  /** A body touches from a gap of so much on, by what its bump sensors can tell. */
  private static final double TOUCH_MM = 2;

  /** Corners are whole mm, and points of contact are looked at every few degrees. */
  private static final double ROUNDING_MM = 3;

  /** A bump sensor feels from straight ahead to the side, and this far beyond both. */
  private static final double OTHER_SIDE_RAD = Angles.fromDegrees(18);

  private static final double SIDE_RAD = Angles.fromDegrees(93);

  /** With the other sensor open, the contact is farther to the side than this. */
  private static final double OFF_CENTER_RAD = Angles.fromDegrees(12);

  private static final double STEP_RAD = Angles.fromDegrees(5);
  private static final int CORNERS = 20;
  private static final double LEAST_HALF_WIDTH_MM = 8;

  /** What a contact proves: nothing if the place is too uncertain, else one mark a closed sensor. */
  public static List<Mark> of(Contact contact, double bodyMm) {
    List<Mark> marks = new ArrayList<>();
    Bumps bumps = contact.bumps();
    if (bumps != Bumps.RIGHT) {
      add(marks, contact, bumps == Bumps.BOTH ? -OTHER_SIDE_RAD : OFF_CENTER_RAD, SIDE_RAD, bodyMm);
    }
    if (bumps != Bumps.LEFT) {
      double to = bumps == Bumps.BOTH ? OTHER_SIDE_RAD : -OFF_CENTER_RAD;
      add(marks, contact, -SIDE_RAD, to, bodyMm);
    }
    return marks;
  }

  private static void add(
      List<Mark> marks, Contact contact, double from, double to, double bodyMm) {
    double errorRad = contact.at().errorRad();
    double sweepRad = to - from + 2 * errorRad;
    if (sweepRad < StrictMath.PI) {
      double first = contact.at().pose().headingRad() + from - errorRad;
      Mark mark =
          new Mark(contact.at().pose().at(), contact.at().errorMm(), first, sweepRad, bodyMm);
      // Else the robot would come back to the same place for ever and learn nothing.
      if (mark.radiusMm(1) > bodyMm) {
        marks.add(mark);
      }
    }
  }

  /**
   * Where the centre of a body cannot be.
   *
   * @param part the body is wider by this part of the margin: 1 for all of it, 0 for the body itself
   * @return null if the contact proves nothing for such a body
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

  /** Wherever the obstacle is, it is this near to the point of contact that is taken for it. */
  private double radiusMm(double part) {
    return bodyMm + part * Errand.MARGIN_MM - TOUCH_MM - errorMm - ROUNDING_MM;
  }

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

  /** From a place inside a circle to its edge. */
  private static double toEdgeMm(Point from, double directionRad, Point center, double radiusMm) {
    Point off = from.minus(center);
    double along =
        off.xMm() * StrictMath.cos(directionRad) + off.yMm() * StrictMath.sin(directionRad);
    return -along + StrictMath.sqrt(along * along - off.dot(off) + radiusMm * radiusMm);
  }
}
