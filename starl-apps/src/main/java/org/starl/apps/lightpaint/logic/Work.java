package org.starl.apps.lightpaint.logic;

import org.starl.geometry.Point;

/**
 * A stroke in the hands of one painter, and how far it has come.
 *
 * @param path in the painter's direction
 * @param doneMm painted so far, from the path's start
 */
record Work(Stroke stroke, boolean isReversed, Polyline path, double doneMm) {

  /** A rest that is shorter is done: the painter stands at its end already. */
  private static final double LEAST_MM = 8;

  /** Since its last note a painter has painted less than this. */
  private static final double UNNOTED_MM = 150;

  static Work of(Stroke stroke, boolean isReversed, double doneMm) {
    Polyline path = isReversed ? stroke.path().reversed() : stroke.path();
    return new Work(stroke, isReversed, path, doneMm);
  }

  /** In the direction that begins nearer to {@code here}. */
  static Work from(Stroke stroke, Point here) {
    double toStartMm = stroke.path().start().distanceMm(here);
    return of(stroke, stroke.path().end().distanceMm(here) < toStartMm, 0);
  }

  /** Where it goes on. */
  Point next() {
    return path.at(doneMm);
  }

  boolean isDone() {
    return path.lengthMm() - doneMm < LEAST_MM;
  }

  Polyline rest() {
    return path.between(doneMm, path.lengthMm());
  }

  /** The painter is here, with its light on since {@link #next}. */
  Work reached(Point here) {
    return of(stroke, isReversed, path.nearestMm(here, doneMm, doneMm + UNNOTED_MM));
  }

  Work finished() {
    return of(stroke, isReversed, path.lengthMm());
  }
}
