package org.starl.apps.lightpaint.logic;

import org.starl.geometry.Point;

/**
 * A stroke that a painter works on, and its progress.
 *
 * @param path the stroke in the painter's direction
 * @param doneMm painted so far, from the path's start
 */
record Work(Stroke stroke, boolean isReversed, Polyline path, double doneMm) {

  /** A shorter remainder counts as done: the painter stands at its end already. */
  private static final double MIN_REST_MM = 8;

  /** Upper bound of what a painter paints between two notes. */
  private static final double MAX_UNNOTED_MM = 150;

  static Work of(Stroke stroke, boolean isReversed, double doneMm) {
    Polyline path = isReversed ? stroke.path().reversed() : stroke.path();
    return new Work(stroke, isReversed, path, doneMm);
  }

  /** All of the stroke, from the end that is nearer to {@code here}. */
  static Work from(Stroke stroke, Point here) {
    double toStartMm = stroke.path().start().distanceMm(here);
    return of(stroke, stroke.path().end().distanceMm(here) < toStartMm, 0);
  }

  /** Where painting continues. */
  Point next() {
    return path.at(doneMm);
  }

  boolean isDone() {
    return path.lengthMm() - doneMm < MIN_REST_MM;
  }

  Polyline rest() {
    return path.between(doneMm, path.lengthMm());
  }

  /** After the painter has painted from {@link #next} to {@code here}. */
  Work paintedTo(Point here) {
    return withDoneMm(path.nearestMm(here, doneMm, doneMm + MAX_UNNOTED_MM));
  }

  Work finished() {
    return withDoneMm(path.lengthMm());
  }

  private Work withDoneMm(double mm) {
    return new Work(stroke, isReversed, path, mm);
  }
}
