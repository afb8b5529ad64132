package org.starl.sim.explore;

/**
 * What to explore. Equal ones have the same schedules, in the same order.
 *
 * @param depth for {@link Strategy#PCT} the changes of priorities, for {@link Strategy#EXHAUSTIVE}
 *     the number of copies whose arrival is chosen
 * @param seed of the draws; {@link Strategy#EXHAUSTIVE} draws nothing
 * @param mostSchedules at least 1
 */
public record Exploration(
    Strategy strategy, int depth, long seed, long mostSchedules, Bounds bounds) {

  public Exploration {
    if (depth < 1 || mostSchedules < 1) {
      throw new IllegalArgumentException(
          "depth %d, %d schedules: expected at least 1".formatted(depth, mostSchedules));
    }
  }
}
