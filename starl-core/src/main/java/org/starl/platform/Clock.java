package org.starl.platform;

/** The robot's own clock. */
public interface Clock {

  /**
   * Time now, in ns from the start of the run; never runs backwards. On the strand it stands still
   * in the simulator and moves on hardware; no safety argument may rest on either.
   */
  long nowNs();
}
