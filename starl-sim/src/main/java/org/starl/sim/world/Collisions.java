package org.starl.sim.world;

/**
 * Counts of contacts between bodies; each contact counts once, regardless of its duration. A
 * contact begins at a gap of {@link World#TOUCH_MM} and ends at {@link World#CLEAR_MM}.
 *
 * @param ofRobots contacts between two robots
 * @param withWalls contacts of a robot with an obstacle
 */
public record Collisions(long ofRobots, long withWalls) {
  /** No contact. */
  public static final Collisions NONE = new Collisions(0, 0);
}
