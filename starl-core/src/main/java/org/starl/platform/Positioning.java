package org.starl.platform;

import org.starl.geometry.Fix;

/** Position measurements (fixes) from an external system: OptiTrack, GPS or the simulated world. */
public interface Positioning {

  /** Sets the one receiver of this robot's fixes; it is called on the strand. Call it once. */
  void onFix(Receiver receiver);

  /** Receives a fix, on the strand. */
  @FunctionalInterface
  interface Receiver {
    void fixed(Fix fix);
  }
}
