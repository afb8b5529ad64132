package org.starl.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;

/** Heap used per robot during a run. */
final class Footprint {

  /** All robots have started then, and no workload has ended. */
  private static final long PROBED_AT_NS = 5_000_000_000L;

  private Footprint() {}

  /** Measured in a run of its own, because it collects garbage in the middle of the run. */
  static long bytesPerRobot(Workload workload, int robots, Workload.Style style, long seed) {
    long before = heldBytes();
    long[] during = {before};
    workload
        .plan(robots, style, seed)
        .director(control -> control.at(PROBED_AT_NS, () -> during[0] = heldBytes()))
        .build()
        .run();
    return Math.max(0, during[0] - before) / robots;
  }

  private static long heldBytes() {
    MemoryMXBean memory = ManagementFactory.getMemoryMXBean();
    memory.gc();
    return memory.getHeapMemoryUsage().getUsed();
  }
}
