package org.starl.platform;

import org.starl.geometry.Fix;

/** Where the robot is, as an outside system measures it: OptiTrack, GPS, or the simulated world. */
public interface Positioning {

  /** Sets the one receiver of this robot's fixes, each on the strand. Called once. */
  void onFix(Receiver receiver);

  /** Takes a fix, on the strand. */
  @FunctionalInterface
  interface Receiver {
    void fixed(Fix fix);
  }
}
