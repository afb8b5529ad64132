package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.ItemPosition;

/**
 * What the robot's sensor shows now: the seam between the search and the device that can tell the
 * thing from a wall (an infrared beacon's receiver, a camera). It is not one of the platform's ports,
 * since no other app has a use for it; whoever starts a {@link SearchApp} hands it one.
 *
 * <p>Contract: every thing to find whose centre is within the range that the {@link House} was made
 * for, with nothing solid on the straight line between, is shown; nothing else is. A device with a
 * narrow beam turns it through a full circle faster than the robot drives half a cell. In simulations
 * it reads the true world.
 */
@FunctionalInterface
public interface Sensing {

  /** The things that are in range and sight, with their places. Strand only; must not wait. */
  List<ItemPosition> sensed();
}
