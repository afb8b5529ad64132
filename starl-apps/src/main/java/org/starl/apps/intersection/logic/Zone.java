package org.starl.apps.intersection.logic;

import org.starl.geometry.Point;

/**
 * The four critical zones of Figure 2, in the order in which a car turns left through them:
 * counter-clockwise, since traffic keeps to the right. The paper's routes A0 A C D D1, A0 A A1 and D0
 * D B B1 fix this ring. Zone A lies in the north-west, x points east and y north.
 */
public enum Zone {
  A(-1, +1, -1, 0),
  C(-1, -1, 0, -1),
  D(+1, -1, +1, 0),
  B(+1, +1, 0, +1);

  private final int east;
  private final int north;
  private final int outwardEast;
  private final int outwardNorth;

  Zone(int east, int north, int outwardEast, int outwardNorth) {
    this.east = east;
    this.north = north;
    this.outwardEast = outwardEast;
    this.outwardNorth = outwardNorth;
  }

  /** The next zone of the ring. */
  public Zone next() {
    return values()[(ordinal() + 1) % values().length];
  }

  /** The zone whose next one this is. */
  public Zone before() {
    return values()[(ordinal() + values().length - 1) % values().length];
  }

  /** Unit vector along the way out of the ring at this zone: A1 leads west, C1 south. */
  Point outward() {
    return new Point(outwardEast, outwardNorth);
  }

  /** Unit vector from this zone to its arrival zone: A0 lies in the north, C0 in the west. */
  Point arrivalSide() {
    return new Point(east - outwardEast, north - outwardNorth);
  }

  /** From the middle of the intersection to the middle of this zone, in zone widths. */
  Point fromMiddle() {
    return new Point(east, north).times(0.5);
  }
}
