package org.starl.sim.world;

/**
 * How often bodies have begun to touch: one count for a contact, however long it lasts and however
 * hard they push. {@link World#TOUCH_MM} apart is touching, {@link World#CLEAR_MM} is not any more.
 *
 * @param ofRobots contacts between two robots
 * @param withWalls contacts of a robot with an obstacle
 */
public record Collisions(long ofRobots, long withWalls) {
  /** Nothing has touched anything. */
  public static final Collisions NONE = new Collisions(0, 0);
}
