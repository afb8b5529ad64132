package org.starl.apps.intersection.logic;

import org.starl.geometry.Point;

/**
 * The four critical zones of Figure 2, in the order in which a car turns left through them:
 * counter-clockwise, since traffic keeps to the right. The paper's routes A0 A C D D1, A0 A A1 and D0
 * D B B1 fix this ring. Zone A lies in the north-west, x points east and y north.
 */
public enum Zone {
  A(-1, +1),
  C(-1, -1),
  D(+1, -1),
  B(+1, +1);

  private final int east;
  private final int north;

  Zone(int east, int north) {
    this.east = east;
    this.north = north;
  }

  /** The next zone of the ring. */
  public Zone next() {
    return values()[(ordinal() + 1) % values().length];
  }

  /** The way out of the ring at this zone, as a unit vector: A1 leads west, C1 south. */
  Point outward() {
    return switch (this) {
      case A -> new Point(-1, 0);
      case C -> new Point(0, -1);
      case D -> new Point(1, 0);
      case B -> new Point(0, 1);
    };
  }

  /** The way back along which cars came to this zone: A0 lies in the north, C0 in the west. */
  Point arrivalSide() {
    return switch (this) {
      case A -> new Point(0, 1);
      case C -> new Point(-1, 0);
      case D -> new Point(0, -1);
      case B -> new Point(1, 0);
    };
  }

  /** From the middle of the intersection to the middle of this zone, in zone widths. */
  Point fromMiddle() {
    return new Point(east * 0.5, north * 0.5);
  }
}
