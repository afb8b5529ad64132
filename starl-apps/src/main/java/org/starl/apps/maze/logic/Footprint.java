package org.starl.apps.maze.logic;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.paths.Path;

/**
 * Which blocks of the floor a body needs. More of them are asked for around a way than a later plan
 * may use, so that a robot that bumps has room to plan again in what it holds. Immutable.
 *
 * @param bodyMm radius of the body
 * @param wanderMm how far from its way it may get after a contact
 */
record Footprint(Blocks blocks, double bodyMm, double wanderMm) {

  /** Blocks are asked for so far around a way, and ways are planned so far inside of them. */
  private static final double ASK_MM = 120;

  private static final double INSIDE_MM = 50;

  /** What to hold for a way. */
  SortedSet<String> along(Path way) {
    return blocks.along(way, bodyMm + ASK_MM + wanderMm);
  }

  /**
   * Where no way may lead for the body to stay in {@code held}, also after a contact.
   *
   * @param isBack for the way back, which has to be found where the body stands already
   */
  List<Polygon> outside(SortedSet<String> held, boolean isBack) {
    return blocks.outside(held, bodyMm + INSIDE_MM + (isBack ? 0 : wanderMm));
  }

  /** What of {@code held} a body does not need that stays at {@code at}. */
  SortedSet<String> spare(SortedSet<String> held, Point at) {
    SortedSet<String> spare = new TreeSet<>(held);
    spare.removeAll(blocks.around(at, bodyMm + ASK_MM));
    return spare;
  }
}
