package org.starl.sim;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.starl.sim.kernel.Activity;
import org.starl.time.Time;

/**
 * Runs an engine on a thread of its own, so that the caller gets an answer even if an action of a
 * robot never ends: Java cannot stop a thread that computes. Such a thread is a daemon; it is
 * abandoned, and with it the run.
 */
final class GuardedRun {

  private static final Duration LOOK = Duration.ofMillis(250);
  private static final long STACK_BYTES = 1 << 20;

  private final Engine engine;
  private final long limitCpuNs;
  // Written by the run's thread, read after it has ended.
  private @Nullable SimResult result;
  private @Nullable Throwable failure;

  GuardedRun(Engine engine, long limitCpuNs) {
    this.engine = engine;
    this.limitCpuNs = limitCpuNs;
  }

  SimResult run() {
    Thread thread = new Thread(null, this::runEngine, "simulation", STACK_BYTES);
    thread.setDaemon(true);
    thread.start();
    boolean wasInterrupted = false;
    try {
      Activity seen = engine.kernel().activity();
      long seenCpuNs = seen.cpuNs();
      while (true) {
        try {
          if (thread.join(LOOK)) {
            return resultOrFailure();
          }
        } catch (InterruptedException e) {
          wasInterrupted = true;
          thread.interrupt();
        }
        Activity now = engine.kernel().activity();
        long cpuNs = now.cpuNs();
        if (now.events() != seen.events() || now.app() != seen.app()) {
          seen = now;
          seenCpuNs = cpuNs;
        } else if (cpuNs - seenCpuNs > limitCpuNs) {
          throw engine.abandon(now.stalled(limitCpuNs / Time.NS_PER_S));
        }
      }
    } finally {
      if (wasInterrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void runEngine() {
    try (engine) {
      result = engine.run();
    } catch (RuntimeException | Error e) {
      failure = e;
    }
  }

  private SimResult resultOrFailure() {
    if (failure instanceof Error error) {
      throw error;
    }
    if (failure instanceof RuntimeException exception) {
      throw exception;
    }
    if (result == null) {
      throw new IllegalStateException("the run's thread ended without a result");
    }
    return result;
  }
}
