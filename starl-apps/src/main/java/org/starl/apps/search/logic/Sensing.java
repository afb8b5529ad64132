package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.ItemPosition;

/**
 * The robot's sensor, which can tell the thing from a wall: the receiver of an infrared beacon, a
 * camera. It is no port of the platform, since no other app uses it; the program that starts a
 * {@link SearchApp} passes one. In simulations it reads the true world.
 *
 * <p>Contract: it shows every thing whose centre is within the range of the {@link House}, with
 * nothing solid on the straight line between, and nothing else. A device with a narrow beam turns
 * it through a full circle faster than the robot drives half a cell.
 */
@FunctionalInterface
public interface Sensing {

  /** The things in range and sight, with their places. Strand only; must not wait. */
  List<ItemPosition> sensed();
}
