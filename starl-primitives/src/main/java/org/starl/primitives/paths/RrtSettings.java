package org.starl.primitives.paths;

/**
 * How a {@link RrtPlanner} searches.
 *
 * @param maxIterations random places that it tries at most, above 0
 * @param stepMm no branch of its tree is longer, above 0
 * @param goalBias with this probability the goal is tried in place of a random place
 * @param shortcuts random shortcuts that it tries on the path that it has found, at least 0
 */
public record RrtSettings(int maxIterations, double stepMm, double goalBias, int shortcuts) {

  public static final RrtSettings DEFAULT = new RrtSettings(5_000, 500, 0.1, 200);

  public RrtSettings {
    if (maxIterations <= 0
        || !(stepMm >= 1)
        || !(goalBias >= 0 && goalBias <= 1)
        || shortcuts < 0) {
      throw new IllegalArgumentException(
          maxIterations
              + " iterations, step "
              + stepMm
              + " mm, goal bias "
              + goalBias
              + ", "
              + shortcuts
              + " shortcuts: expected at least 1, 1, 0 to 1, 0");
    }
  }
}
