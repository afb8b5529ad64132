package org.starl.sim.kernel;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.jspecify.annotations.Nullable;

/**
 * The action that a kernel runs at a moment.
 *
 * @param events run so far, with this one
 * @param nowNs virtual time
 * @param strand name of the robot that acts, or empty: the world
 * @param kernel the kernel's thread; null before and after the run, where no action runs
 * @param app the app's thread, if the app itself acts; null if a handler or a timer does
 */
public record Activity(
    long events, long nowNs, String strand, @Nullable Thread kernel, @Nullable Thread app) {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** The processor time of the threads that run the action, in ns; grows while they compute. */
  public long cpuNs() {
    return cpuNs(kernel) + (app == null || app.isVirtual() ? 0 : cpuNs(app));
  }

  /** The error that ends a run in this action, after {@code cpuSeconds} without an end. */
  public RuntimeException stalled(long cpuSeconds) {
    Thread busy = app == null ? kernel : app;
    StackTraceElement[] stack = busy == null ? new StackTraceElement[0] : busy.getStackTrace();
    Stalled stalled = Stalled.action(cpuSeconds, stack);
    return strand.isEmpty() ? stalled : new RobotError(strand, nowNs, stalled);
  }

  private static long cpuNs(@Nullable Thread thread) {
    return thread == null ? 0 : Math.max(0, THREADS.getThreadCpuTime(thread.threadId()));
  }
}
