package org.starl.sim.kernel;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** A wake-up of a robot on each kind of carrier: the kernel switches to its stack and back. */
@State(Scope.Thread)
public class WakeUpBenchmark {

  private static final int WAKE_UPS = 10_000;
  private static final long PERIOD_NS = 1_000_000;

  @Param({"VIRTUAL", "PLATFORM"})
  private CarrierKind carrier;

  /** A robot that sleeps and wakes up. */
  @Benchmark
  @OperationsPerInvocation(WAKE_UPS)
  public long sleep() {
    try (Kernel kernel = new Kernel(carrier)) {
      SimStrand robot = kernel.strand("robot");
      robot.start(() -> {
        for (int i = 0; i < WAKE_UPS; i++) {
          robot.sleepUntil(kernel.nowNs() + PERIOD_NS);
        }
      });
      kernel.run(Long.MAX_VALUE, () -> false);
      return kernel.events();
    }
  }
}
