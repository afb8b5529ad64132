package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.geometry.Point;

/**
 * How much of a room one robot has seen for certain, by its own positions and their error bounds.
 * Strand only.
 */
final class Coverage {

  /** A robot that moved less has hardly anything new in view. */
  private static final double STEP_MM = 20;

  private final House house;
  private final BitSet unseen;
  private Point last = new Point(Double.NEGATIVE_INFINITY, 0);
  private double lastErrorMm;

  /**
   * @param wanted the cells to see
   */
  Coverage(House house, BitSet wanted) {
    this.house = house;
    unseen = (BitSet) wanted.clone();
  }

  /** The sensor is looked at now, and the robot is within {@code errorMm} of {@code at}. */
  void look(Point at, double errorMm) {
    boolean isNews = at.distanceMm(last) >= STEP_MM || errorMm < lastErrorMm;
    if (unseen.isEmpty() || !isNews) {
      return;
    }
    last = at;
    lastErrorMm = errorMm;
    house
        .grid()
        .forEachWithin(
            at,
            house.rangeMm(),
            cell -> {
              if (unseen.get(cell) && house.covers(at, errorMm, cell)) {
                unseen.clear(cell);
              }
            });
  }

  /** These cells need not be seen: no place has them in view. */
  void forget(BitSet hidden) {
    unseen.andNot(hidden);
  }

  boolean isComplete() {
    return unseen.isEmpty();
  }

  /** A set of the caller's own. */
  BitSet unseen() {
    return (BitSet) unseen.clone();
  }

  /** Whether something unseen may come into view on the way from one point to the other. */
  boolean isWorthGoing(Leg leg) {
    for (int cell = unseen.nextSetBit(0); cell >= 0; cell = unseen.nextSetBit(cell + 1)) {
      if (leg.distanceMm(house.grid().centre(cell)) <= house.rangeMm()) {
        return true;
      }
    }
    return false;
  }
}
