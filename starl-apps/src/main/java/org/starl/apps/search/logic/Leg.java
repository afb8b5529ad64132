package org.starl.apps.search.logic;

import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/** A straight part of a sweep; one place if both ends are equal. */
public record Leg(Point from, Point to) {

  Leg reversed() {
    return new Leg(to, from);
  }

  boolean isPlace() {
    return from.equals(to);
  }

  double lengthMm() {
    return from.distanceMm(to);
  }

  /**
   * A place on it.
   *
   * @param part 0 at its beginning, 1 at its end
   */
  Point at(double part) {
    return from.plus(to.minus(from).times(part));
  }

  double distanceMm(Point point) {
    return new Segment(from, to).distanceMm(point);
  }

  /** {@code 500,1500>900,1500}. */
  @Override
  public String toString() {
    return text(from) + (isPlace() ? "" : ">" + text(to));
  }

  private static String text(Point point) {
    return Math.round(point.xMm()) + "," + Math.round(point.yMm());
  }
}
