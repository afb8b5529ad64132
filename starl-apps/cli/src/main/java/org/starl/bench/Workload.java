package org.starl.bench;

import org.starl.sim.Simulation;

/** A simulation that is run to see how fast it runs. */
public interface Workload {

  /** As in {@code starl bench NAME}. */
  String name();

  /** One line. */
  String summary();

  /** How the robots' apps are written. */
  enum Style {
    BLOCKING,
    STEP
  }

  /**
   * The same simulation for the same arguments.
   *
   * @throws org.starl.input.BadInput if it cannot be run with so many robots or in this style
   */
  Simulation.Builder plan(int robots, Style style, long seed);
}
