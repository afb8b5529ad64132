package org.starl.sim.world;

/**
 * What bodies can do at most, and whether they are solid.
 *
 * @param maxMmPerS no body drives faster, forwards or backwards
 * @param maxRadPerS no body turns faster
 * @param collisions whether bodies and walls are solid; where not, bodies pass through everything
 *     and nothing bumps
 */
public record WorldLimits(double maxMmPerS, double maxRadPerS, boolean collisions) {

  /** What an iRobot Create can do: 500 mm/s a wheel, wheels 258 mm apart; solid. */
  public static final WorldLimits CREATE = new WorldLimits(500, 2 * 500 / 258.0, true);

  public WorldLimits {
    if (!(maxMmPerS > 0) || !(maxRadPerS > 0)) {
      throw new IllegalArgumentException(
          "limits " + maxMmPerS + " mm/s, " + maxRadPerS + " rad/s: expected above 0");
    }
  }

  /** The same limits with bodies that pass through each other and through walls. */
  public WorldLimits withoutCollisions() {
    return new WorldLimits(maxMmPerS, maxRadPerS, false);
  }

  double mmPerS(double wanted) {
    return Math.max(-maxMmPerS, Math.min(maxMmPerS, wanted));
  }

  double radPerS(double wanted) {
    return Math.max(-maxRadPerS, Math.min(maxRadPerS, wanted));
  }
}
