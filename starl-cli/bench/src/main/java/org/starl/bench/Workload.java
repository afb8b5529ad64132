package org.starl.bench;

import java.util.List;
import org.starl.sim.Simulation;

/** A simulation whose speed is measured. */
public interface Workload {

  /** All workloads. */
  static List<Workload> all() {
    return List.of(
        new KernelWorkload(),
        new PatrolWorkload(),
        new SwarmWorkload(SwarmWorkload.Variant.RADIO),
        new SwarmWorkload(SwarmWorkload.Variant.SIGHT),
        new SwarmWorkload(SwarmWorkload.Variant.DISCS),
        new TownWorkload());
  }

  /** Name in {@code starl bench NAME}. */
  String name();

  /** One line for people. */
  String summary();

  /** The style of its apps unless another one is asked for. */
  default Style style() {
    return Style.BLOCKING;
  }

  /** The style of the robots' apps. */
  enum Style {
    BLOCKING,
    STEP,
    SUSPENDED
  }

  /**
   * The same simulation for the same arguments.
   *
   * @throws org.starl.input.BadInput if it cannot be run with so many robots or in this style
   */
  Simulation.Builder plan(int robots, Style style, long seed);
}
