package org.starl.apps.maze.logic;

import org.starl.geometry.Point;

/**
 * A place to go to.
 *
 * @param toleranceMm a robot is there when it is nearer than this; above 0
 */
public record Goal(String name, Point at, double toleranceMm) {

  public Goal {
    if (!(toleranceMm > 0) || !at.isFinite()) {
      throw new IllegalArgumentException(name + " at " + at + ", tolerance " + toleranceMm + " mm");
    }
  }
}
