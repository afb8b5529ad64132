package org.starl.platform;

import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/**
 * The wheels and the bump sensors. What must not wait for the strand lives below this port: the
 * watchdog that stops wheels whose program has fallen silent, and the bump stop.
 */
public interface Chassis {

  /**
   * Drives so from now on, until the next call. Who moves repeats it at each step of the motion
   * automaton: a chassis on hardware takes a program that falls silent for dead, and stops.
   */
  void drive(WheelCommand command);

  /** What the bump sensors say now. */
  Bumps bumps();

  /** Sets the one receiver that is called, on the strand, when {@link #bumps} changes. */
  void onBump(Runnable receiver);
}
