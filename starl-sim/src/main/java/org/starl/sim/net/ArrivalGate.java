package org.starl.sim.net;

/** Between a robot's radio and its program; may delay arrivals. */
@FunctionalInterface
public interface ArrivalGate {

  /** Runs {@code arrival} on the robot's current strand: at once, or later in order. */
  void pass(Runnable arrival);
}
