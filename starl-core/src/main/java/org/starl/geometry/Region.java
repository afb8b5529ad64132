package org.starl.geometry;

/**
 * A closed set of points in the plane: it includes its border. Immutable; regions are equal if
 * their descriptions are equal.
 */
public sealed interface Region permits Circle, Rectangle, Polygon, Union, Nowhere, Everywhere {

  boolean contains(Point point);

  /** Distance to the nearest point of the region; 0 inside, infinite for the empty region. */
  double distanceMm(Point point);

  /**
   * Radius of a disc around {@code point} that lies in the region: 0 outside, infinite if the
   * region has no border. For a {@link Union} it is a lower bound: that of the best part.
   */
  double depthMm(Point point);
}
