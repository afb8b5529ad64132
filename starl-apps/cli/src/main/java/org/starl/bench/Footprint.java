package org.starl.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;

/** How much of the heap a robot holds while it runs. */
final class Footprint {

  /** Every robot is up then, and no workload is over. */
  private static final long PROBED_AT_NS = 5_000_000_000L;

  private Footprint() {}

  /** Runs {@code workload} once more for this, since a collection in its middle takes time. */
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
