package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * What one robot has not seen yet of some cells, by its positions and their error bounds. Strand
 * only.
 */
final class Coverage {

  /** A robot that moved less sees hardly anything new. */
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

  /** The sensor was read now, and the robot is within {@code errorMm} of {@code at}. */
  void look(Point at, double errorMm) {
    if (at.distanceMm(last) >= STEP_MM || errorMm < lastErrorMm) {
      last = at;
      lastErrorMm = errorMm;
      unseen.andNot(house.view(at, errorMm, unseen));
    }
  }

  /** These cells need not be seen. */
  void forget(BitSet hidden) {
    unseen.andNot(hidden);
  }

  boolean isComplete() {
    return unseen.isEmpty();
  }

  /** The caller may change the set. */
  BitSet unseen() {
    return (BitSet) unseen.clone();
  }

  /** Whether a cell that was not seen may come into view on a leg. */
  boolean isWorthDriving(Segment leg) {
    return unseen.stream()
        .anyMatch(cell -> leg.distanceMm(house.grid().centre(cell)) <= house.rangeMm());
  }
}
