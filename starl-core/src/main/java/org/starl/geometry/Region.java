package org.starl.geometry;

/**
 * A closed set of points of the plane: its border belongs to it. Immutable; two regions are equal
 * if they are written alike.
 */
public sealed interface Region permits Circle, Rectangle, Polygon, Union, Nowhere, Everywhere {

  boolean contains(Point point);

  /** Distance from the nearest point of the region; 0 inside, infinite from an empty region. */
  double distanceMm(Point point);

  /**
   * A disc of this radius around {@code point} lies in the region: 0 outside, infinite where the
   * region has no border. For a {@link Union} it is a lower bound, that of the best part.
   */
  double depthMm(Point point);
}
