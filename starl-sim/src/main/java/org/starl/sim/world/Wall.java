package org.starl.sim.world;

import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/** One straight side of an obstacle, for the collider. */
final class Wall {

  private final double fromX;
  private final double fromY;
  private final double alongX;
  private final double alongY;
  private final double square;
  final long untilNs;
  // The last query that visited this wall, which may be in several cells.
  long seenBy;

  Wall(double fromX, double fromY, double toX, double toY, long untilNs) {
    this.fromX = fromX;
    this.fromY = fromY;
    this.alongX = toX - fromX;
    this.alongY = toY - fromY;
    this.square = alongX * alongX + alongY * alongY;
    this.untilNs = untilNs;
  }

  boolean standsAt(long nowNs) {
    return nowNs < untilNs;
  }

  /** The nearest point of the wall, rounded to mm, as text. */
  String nearestTo(double x, double y) {
    return "(" + Math.round(nearestX(x, y)) + ", " + Math.round(nearestY(x, y)) + ")";
  }

  /** The x coordinate of the nearest point of the wall. */
  double nearestX(double x, double y) {
    return fromX + alongX * part(x, y);
  }

  double nearestY(double x, double y) {
    return fromY + alongY * part(x, y);
  }

  double distanceMm(double x, double y) {
    double part = part(x, y);
    double dx = fromX + alongX * part - x;
    double dy = fromY + alongY * part - y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Whether the wall and {@code line} have a common point. */
  boolean crosses(Segment line) {
    Segment side = new Segment(new Point(fromX, fromY), new Point(fromX + alongX, fromY + alongY));
    return line.crosses(side);
  }

  double leastX() {
    return Math.min(fromX, fromX + alongX);
  }

  double mostX() {
    return Math.max(fromX, fromX + alongX);
  }

  double leastY() {
    return Math.min(fromY, fromY + alongY);
  }

  double mostY() {
    return Math.max(fromY, fromY + alongY);
  }

  private double part(double x, double y) {
    double part = square == 0 ? 0 : ((x - fromX) * alongX + (y - fromY) * alongY) / square;
    return Math.max(0, Math.min(1, part));
  }
}
