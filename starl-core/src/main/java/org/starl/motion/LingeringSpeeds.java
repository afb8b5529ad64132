package org.starl.motion;

/**
 * The commands that may still be in effect, because a new one takes effect late: the hull of their
 * speeds and standstill.
 */
record LingeringSpeeds(
    double leastMmPerS, double mostMmPerS, double leastRadPerS, double mostRadPerS) {

  static final LingeringSpeeds NONE = new LingeringSpeeds(0, 0, 0, 0);

  /**
   * By how much the body may drive faster than {@code told}, or how fast in the opposite direction.
   */
  double beyondMmPerS(double told) {
    return Math.max(beyond(told, leastMmPerS), beyond(told, mostMmPerS));
  }

  /**
   * By how much the body may turn faster than {@code told}, or how fast in the opposite direction.
   */
  double beyondRadPerS(double told) {
    return Math.max(beyond(told, leastRadPerS), beyond(told, mostRadPerS));
  }

  LingeringSpeeds with(double mmPerS, double radPerS) {
    return new LingeringSpeeds(
        Math.min(leastMmPerS, mmPerS),
        Math.max(mostMmPerS, mmPerS),
        Math.min(leastRadPerS, radPerS),
        Math.max(mostRadPerS, radPerS));
  }

  /** By how much {@code old} is outside the range from 0 to {@code told}. */
  static double beyond(double told, double old) {
    return Math.max(0, Math.max(old - Math.max(0, told), Math.min(0, told) - old));
  }
}
