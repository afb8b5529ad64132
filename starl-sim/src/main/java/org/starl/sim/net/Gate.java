package org.starl.sim.net;

/** What lies between a robot's radio and its program. */
@FunctionalInterface
public interface Gate {

  /** Runs {@code arrival} on the robot's strand, which runs now: at once, or when its turn comes. */
  void pass(Runnable arrival);
}
