package org.starl.sim.world;

import java.util.List;
import org.starl.geometry.ItemPosition;

/**
 * Objects on a simulated floor and the sensors that all robots have for them. Objects are points:
 * bodies do not touch them. Immutable.
 *
 * @param objects with different names
 * @param rangeMm of the sensors, above 0
 */
public record FloorObjects(List<ItemPosition> objects, double rangeMm) {

  public FloorObjects {
    if (!(rangeMm > 0)) {
      throw new IllegalArgumentException("range " + rangeMm + " mm: expected above 0");
    }
    objects = List.copyOf(objects);
  }
}
