package org.starl.sim.net;

/** Stands between a robot's radio and its program, and may delay what arrives. */
@FunctionalInterface
public interface ArrivalGate {

  /** Runs {@code arrival} on the robot's strand, which is running: at once, or in its turn. */
  void pass(Runnable arrival);
}
