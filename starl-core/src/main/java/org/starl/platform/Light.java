package org.starl.platform;

/**
 * A light that the robot carries. Implementations: a Create's power button, a phone's screen. In
 * the simulator the trace alone has the light, as a variable. Strand only; no call waits.
 */
@FunctionalInterface
public interface Light {

  /** The simulator's: {@code gvh.plat.light} has written the variable already. */
  Light SIMULATED = rgb -> {};

  /** Colours have 24 bits. */
  int MAX_RGB = 0xFFFFFF;

  /**
   * Shows a colour until the next call, as exactly as the light can.
   *
   * @param rgb from 0, which is off, to {@link #MAX_RGB}, red first
   */
  void show(int rgb);
}
