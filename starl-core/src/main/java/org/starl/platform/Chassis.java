package org.starl.platform;

import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/**
 * The wheels and the bump sensors. Reactions that cannot wait for the strand are implemented below
 * this port: the watchdog that stops the wheels when the program is silent, and the stop at a bump.
 */
public interface Chassis {

  /**
   * Drives with this command until the next call. The caller repeats it at each step of the motion
   * automaton while the robot moves: a chassis on hardware stops if the program is silent.
   */
  void drive(WheelCommand command);

  /** The bump sensors' current state. */
  Bumps bumps();

  /** Sets the one receiver that is called, on the strand, when {@link #bumps} changes. */
  void onBump(Runnable receiver);
}
