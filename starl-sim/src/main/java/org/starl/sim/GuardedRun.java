package org.starl.sim;

import static java.util.concurrent.TimeUnit.MILLISECONDS;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.starl.sim.kernel.Activity;
import org.starl.time.Time;

/**
 * Runs an engine on a thread of its own, so that the caller gets an answer even if an action of a
 * robot never ends: Java cannot stop a thread that computes. Such a thread is a daemon; it is
 * abandoned, and with it the run.
 */
final class GuardedRun {

  private static final long LOOK_MS = 250;
  private static final long STACK_BYTES = 1 << 20;

  private final Engine engine;
  private final long limitCpuNs;

  GuardedRun(Engine engine, long limitCpuNs) {
    this.engine = engine;
    this.limitCpuNs = limitCpuNs;
  }

  SimResult run() {
    FutureTask<SimResult> run =
        new FutureTask<>(
            () -> {
              try (engine) {
                return engine.run();
              }
            });
    Thread thread = new Thread(null, run, "simulation", STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    boolean wasInterrupted = false;
    Activity seen = engine.kernel().activity();
    long seenCpuNs = seen.cpuNs();
    try {
      while (true) {
        try {
          return run.get(LOOK_MS, MILLISECONDS);
        } catch (InterruptedException e) {
          wasInterrupted = true;
          thread.interrupt();
        } catch (TimeoutException e) {
          Activity now = engine.kernel().activity();
          long cpuNs = now.cpuNs();
          if (now.events() != seen.events() || now.app() != seen.app()) {
            seen = now;
            seenCpuNs = cpuNs;
          } else if (cpuNs - seenCpuNs > limitCpuNs) {
            throw engine.abandon(now.stalled(limitCpuNs / Time.NS_PER_S));
          }
        }
      }
    } catch (ExecutionException e) {
      throw unwrapped(e.getCause());
    } finally {
      if (wasInterrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static RuntimeException unwrapped(@Nullable Throwable cause) {
    if (cause instanceof Error error) {
      throw error;
    }
    return cause instanceof RuntimeException e ? e : new IllegalStateException(cause);
  }
}
