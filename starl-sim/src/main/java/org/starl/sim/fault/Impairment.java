package org.starl.sim.fault;

import org.starl.sim.world.PositionNoise;

/**
 * What is wrong with one robot's parts. Several add up.
 *
 * @param wheels the fraction of what the wheels are told that they do, from 0 (stuck) to 1
 * @param noise fixes are so much farther off the truth, and say so
 * @param isBlind whether no fixes come
 * @param offXMm fixes are off the truth by this, and do not say so
 * @param driftPpm so many microseconds a second the robot's clock is too fast; below 0, too slow
 * @param skewNs so much the robot's clock is ahead; below 0, behind
 * @param computeNs every action of the robot takes so long
 * @param diskNs writes to stable storage take so much longer until they survive a crash
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

  static Impairment ofTime(long driftPpm, long skewNs, long computeNs) {
    return new Impairment(1, PositionNoise.NONE, false, 0, 0, driftPpm, skewNs, computeNs, 0);
  }

  static Impairment ofDisk(long diskNs) {
    return new Impairment(1, PositionNoise.NONE, false, 0, 0, 0, 0, 0, diskNs);
  }

  /** Both at once. */
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
