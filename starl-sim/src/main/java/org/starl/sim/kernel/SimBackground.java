package org.starl.sim.kernel;

import org.starl.platform.Background;

/**
 * Computes at once and delivers the result after a fixed virtual time per task. Simulates one
 * worker, as on hardware: a task waits for the tasks before it.
 */
public final class SimBackground implements Background {

  private final Kernel kernel;
  private final SimStrand strand;
  private final long costNs;
  private long freeNs;

  /**
   * @param costNs the virtual time per task, at least 0
   */
  public SimBackground(Kernel kernel, SimStrand strand, long costNs) {
    if (costNs < 0) {
      throw new IllegalArgumentException("cost " + costNs + " ns: expected at least 0");
    }
    this.kernel = kernel;
    this.strand = strand;
    this.costNs = costNs;
  }

  @Override
  public void submit(Runnable task, Runnable done) {
    if (strand.isClosed()) {
      return;
    }
    Runnable outcome = compute(task, done);
    freeNs = Math.max(freeNs, kernel.nowNs()) + costNs;
    kernel.schedule(freeNs, strand, outcome);
  }

  /**
   * While a task computes, no strand is current: a task that waits or claims to be on a strand
   * fails.
   */
  private Runnable compute(Runnable task, Runnable done) {
    SimStrand caller = kernel.current();
    kernel.setCurrent(null);
    try {
      task.run();
      return done;
    } catch (RuntimeException | Error e) {
      return () -> {
        throw e;
      };
    } finally {
      kernel.setCurrent(caller);
    }
  }
}
