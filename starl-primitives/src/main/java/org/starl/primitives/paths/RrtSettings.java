package org.starl.primitives.paths;

/**
 * The settings of a {@link RrtPlanner}.
 *
 * @param maxIterations the largest number of random points to try, above 0
 * @param stepMm the largest length of a branch of the tree, at least 1
 * @param goalBias the probability to try the goal instead of a random point
 * @param shortcuts the number of random shortcuts to try on the path, at least 0
 */
public record RrtSettings(int maxIterations, double stepMm, double goalBias, int shortcuts) {

  public static final RrtSettings DEFAULT = new RrtSettings(5_000, 500, 0.1, 200);

  public RrtSettings {
    if (maxIterations <= 0
        || !(stepMm >= 1)
        || !(goalBias >= 0 && goalBias <= 1)
        || shortcuts < 0) {
      throw new IllegalArgumentException(
          String.format(
              "%s iterations, step %s mm, goal bias %s, %s shortcuts: expected at least 1, 1, 0 to 1, 0",
              maxIterations, stepMm, goalBias, shortcuts));
    }
  }
}
