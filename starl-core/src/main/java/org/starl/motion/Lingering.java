package org.starl.motion;

import org.starl.body.WheelCommand;

/**
 * The commands that the wheels may still follow, because a new one takes effect late: the hull of
 * their speeds and of standing still.
 */
record Lingering(double leastMmPerS, double mostMmPerS, double leastRadPerS, double mostRadPerS) {

  static final Lingering NONE = new Lingering(0, 0, 0, 0);

  /** How much faster than {@code told}, or how fast against it, the body may drive meanwhile. */
  double beyondMmPerS(double told) {
    return Math.max(beyond(told, leastMmPerS), beyond(told, mostMmPerS));
  }

  /** How much faster than {@code told}, or how fast against it, the body may turn meanwhile. */
  double beyondRadPerS(double told) {
    return Math.max(beyond(told, leastRadPerS), beyond(told, mostRadPerS));
  }

  Lingering with(WheelCommand command) {
    return new Lingering(
        Math.min(leastMmPerS, command.linearMmPerS()),
        Math.max(mostMmPerS, command.linearMmPerS()),
        Math.min(leastRadPerS, command.angularRadPerS()),
        Math.max(mostRadPerS, command.angularRadPerS()));
  }

  /** By how much {@code old} lies outside of what {@code told} allows: all from 0 to it. */
  static double beyond(double told, double old) {
    return Math.max(0, Math.max(old - Math.max(0, told), Math.min(0, told) - old));
  }
}
