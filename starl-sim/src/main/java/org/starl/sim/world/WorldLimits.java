package org.starl.sim.world;

/**
 * The maximum speeds of bodies, and whether bodies are solid.
 *
 * @param maxMmPerS the maximum speed, forwards and backwards
 * @param maxRadPerS the maximum turning speed
 * @param collisions whether bodies and walls are solid; if not, bodies pass through everything and
 *     no bump occurs
 * @param turnsAtContact whether a body whose wheels push it against something turns away from that
 */
public record WorldLimits(
    double maxMmPerS, double maxRadPerS, boolean collisions, boolean turnsAtContact) {

  /** The limits of an iRobot Create: 500 mm/s per wheel, wheels 258 mm apart; solid. */
  public static final WorldLimits CREATE = new WorldLimits(500, 2 * 500 / 258.0, true, false);

  public WorldLimits {
    if (!(maxMmPerS > 0) || !(maxRadPerS > 0)) {
      throw new IllegalArgumentException(
          "limits " + maxMmPerS + " mm/s, " + maxRadPerS + " rad/s: expected above 0");
    }
  }

  double mmPerS(double wanted) {
    return Math.max(-maxMmPerS, Math.min(maxMmPerS, wanted));
  }

  double radPerS(double wanted) {
    return Math.max(-maxRadPerS, Math.min(maxRadPerS, wanted));
  }
}
