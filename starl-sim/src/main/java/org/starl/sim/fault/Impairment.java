package org.starl.sim.fault;

import org.starl.sim.world.PositionNoise;

/**
 * The impairments of one robot's parts, summed over its faults.
 *
 * @param wheels wheel speed as a fraction of the commanded speed, from 0 (stuck) to 1
 * @param noise additional error of fixes, as large as this, included in the bound that they report
 * @param isBlind whether there are no fixes
 * @param offXMm additional error of fixes along x, not included in that bound
 * @param offYMm additional error of fixes along y, not included in that bound
 * @param driftPpm rate by which the robot's clock is too fast, in us per s; below 0, too slow
 * @param skewNs time by which the robot's clock is ahead, in ns; below 0, behind
 * @param computeNs time that each action of the robot takes, in ns
 * @param diskNs additional time until a write to stable storage survives a crash, in ns
 */
public record Impairment(
    double wheels,
    PositionNoise noise,
    boolean isBlind,
    double offXMm,
    double offYMm,
    long driftPpm,
    long skewNs,
    long computeNs,
    long diskNs) {

  public static final Impairment NONE =
      new Impairment(1, PositionNoise.NONE, false, 0, 0, 0, 0, 0, 0);

  static Impairment ofWheels(double wheels) {
    return new Impairment(wheels, PositionNoise.NONE, false, 0, 0, 0, 0, 0, 0);
  }

  static Impairment ofPositioning(
      PositionNoise noise, boolean isBlind, double offXMm, double offYMm) {
    return new Impairment(1, noise, isBlind, offXMm, offYMm, 0, 0, 0, 0);
  }

  public static Impairment ofTime(long driftPpm, long skewNs, long computeNs) {
    return new Impairment(1, PositionNoise.NONE, false, 0, 0, driftPpm, skewNs, computeNs, 0);
  }

  static Impairment ofDisk(long diskNs) {
    return new Impairment(1, PositionNoise.NONE, false, 0, 0, 0, 0, 0, diskNs);
  }

  /** The sum of both impairments. */
  public Impairment plus(Impairment other) {
    return new Impairment(
        wheels * other.wheels,
        noise.plus(other.noise),
        isBlind || other.isBlind,
        offXMm + other.offXMm,
        offYMm + other.offYMm,
        driftPpm + other.driftPpm,
        skewNs + other.skewNs,
        computeNs + other.computeNs,
        diskNs + other.diskNs);
  }
}
