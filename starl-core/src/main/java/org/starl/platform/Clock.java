package org.starl.platform;

/** The robot's own clock. */
public interface Clock {

  /**
   * The time in ns since the start of the run; never decreases. While strand code runs, it stands
   * still in the simulator and advances on hardware; no safety argument may depend on either.
   */
  long nowNs();
}
