package org.starl.sim.kernel;

import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.starl.platform.Timer;
import org.starl.random.Rng;

/**
 * Measures the bare kernel: each robot waits 100 ms and sends a message to a random other robot, with
 * an exponential delay of mean 50 ms; 100 times. Run it by hand: {@code KernelBench robots
 * repetitions}.
 */
final class KernelBench {

  private static final int ROUNDS = 100;
  private static final long PERIOD_NS = 100_000_000;
  private static final double MEAN_DELAY_NS = 50e6;

  private final Rng rng = new Rng(42);
  private final Kernel kernel;
  private final SimStrand[] robots;
  private final Runnable[] deliveries;
  private final long[] received;

  private KernelBench(CarrierKind kind, int count) {
    kernel = new Kernel(kind);
    robots = new SimStrand[count];
    deliveries = new Runnable[count];
    received = new long[count];
    for (int i = 0; i < count; i++) {
      int self = i;
      robots[i] = kernel.strand("robot" + i);
      deliveries[i] = () -> received[self]++;
    }
  }

  public static void main(String[] args) {
    int robots = Integer.parseInt(args[0]);
    for (int i = 0; i < Integer.parseInt(args[1]); i++) {
      for (CarrierKind kind : CarrierKind.values()) {
        if (kind == CarrierKind.VIRTUAL || robots <= 1000) {
          KernelBench blocking = new KernelBench(kind, robots);
          blocking.startBlocking();
          blocking.measure("blocking " + kind);
        }
      }
      KernelBench stepping = new KernelBench(CarrierKind.PLATFORM, robots);
      stepping.startStepping();
      stepping.measure("stepping");
    }
  }

  private void startBlocking() {
    for (int i = 0; i < robots.length; i++) {
      int self = i;
      SimStrand robot = robots[i];
      long phaseNs = rng.nextLong(0, PERIOD_NS);
      robot.start(() -> {
        robot.sleepUntil(phaseNs);
        for (int round = 0; round < ROUNDS; round++) {
          robot.sleepUntil(kernel.nowNs() + PERIOD_NS);
          send(self);
        }
      });
    }
  }

  private void startStepping() {
    for (int i = 0; i < robots.length; i++) {
      int self = i;
      int[] rounds = {0};
      Timer[] timer = new Timer[1];
      timer[0] =
          robots[i].timer(() -> {
            send(self);
            if (++rounds[0] < ROUNDS) {
              timer[0].set(kernel.nowNs() + PERIOD_NS);
            }
          });
      timer[0].set(PERIOD_NS + rng.nextLong(0, PERIOD_NS));
    }
  }

  private void send(int from) {
    int other = rng.nextInt(robots.length - 1);
    int to = other >= from ? other + 1 : other;
    long delayNs = (long) (rng.nextExponential() * MEAN_DELAY_NS);
    kernel.schedule(kernel.nowNs() + delayNs, robots[to], deliveries[to]);
  }

  private void measure(String what) {
    kernel.run(0, () -> false);
    long before = usedBytes();
    double startS = processCpuSeconds();
    double threadStartS = threadCpuSeconds();
    long events = kernel.events();
    kernel.run(Long.MAX_VALUE, () -> false);
    double threadCpuS = threadCpuSeconds() - threadStartS;
    double cpuS = processCpuSeconds() - startS;
    long sum = 0;
    for (long count : received) {
      sum += count;
    }
    if (sum != (long) ROUNDS * robots.length) {
      throw new IllegalStateException("lost messages: " + sum);
    }
    System.out.printf(
        Locale.ROOT,
        "%-18s %7d robots %6.2f M events per CPU-second (%.2f of the kernel's thread), %d MB%n",
        what,
        robots.length,
        (kernel.events() - events) / cpuS / 1e6,
        (kernel.events() - events) / threadCpuS / 1e6,
        before >> 20);
    kernel.close();
  }

  private static double threadCpuSeconds() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / 1e9;
  }

  private static double processCpuSeconds() {
    return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
            .getProcessCpuTime()
        / 1e9;
  }

  private static long usedBytes() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }
}
