package org.starl.sim.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;
import org.jspecify.annotations.Nullable;

/**
 * Many runs that differ in their seeds, on all cores: one run at a time on each thread, nothing
 * shared between them. The result depends on the seeds alone.
 *
 * @param firstSeed of the first run
 * @param lastSeed of the last run, not below the first
 * @param workers threads
 * @param stopAtBad whether no run counts after the first one, in the order of seeds, that went badly
 */
public record Campaign(long firstSeed, long lastSeed, int workers, boolean stopAtBad) {

  /** Told on the calling thread after each run; a run that turns out not to count is told as well. */
  @FunctionalInterface
  public interface Progress {

    /**
     * @param finished runs so far
     * @param planned runs of the whole campaign, if nothing stops it
     * @param bad runs so far that did not go well
     */
    void advanced(long finished, long planned, long bad);
  }

  public Campaign {
    long planned = lastSeed - firstSeed + 1;
    if (lastSeed < firstSeed || planned <= 0 || planned > Integer.MAX_VALUE) {
      throw new IllegalArgumentException(
          "seeds " + firstSeed + ".." + lastSeed + ": expected the smaller one first, below 2^31");
    }
    if (workers <= 0) {
      throw new IllegalArgumentException("campaign on " + workers + " threads: expected some");
    }
  }

  /** On all cores, to the end, whatever the runs are like. */
  public Campaign(long firstSeed, long lastSeed) {
    this(firstSeed, lastSeed, Runtime.getRuntime().availableProcessors(), false);
  }

  /** The result of one run, or the error that is no exception of a run but ends the campaign. */
  private record Finished(long seed, @Nullable RunOutcome outcome, @Nullable Error error) {}

  /** What the calling thread and the workers have in common. */
  private final class Shared {
    private final LongFunction<RunOutcome> runner;
    private final AtomicLong nextIndex = new AtomicLong();
    private final AtomicLong endIndex = new AtomicLong(planned());
    private final BlockingQueue<Finished> finished = new LinkedBlockingQueue<>();

    Shared(LongFunction<RunOutcome> runner) {
      this.runner = runner;
    }

    void work() {
      long index = nextIndex.getAndIncrement();
      while (index < endIndex.get()) {
        Finished run = runOne(firstSeed + index);
        RunOutcome outcome = run.outcome();
        if (outcome == null || (stopAtBad && !outcome.isGood())) {
          long mine = index + 1;
          endIndex.accumulateAndGet(mine, Math::min);
        }
        finished.add(run);
        index = nextIndex.getAndIncrement();
      }
      finished.add(new Finished(0, null, null));
    }

    private Finished runOne(long seed) {
      try {
        return new Finished(seed, runner.apply(seed), null);
      } catch (RuntimeException e) {
        return new Finished(seed, RunOutcome.failed(e), null);
      } catch (Error e) {
        return new Finished(seed, null, e);
      }
    }
  }

  /**
   * Runs it.
   *
   * @param runner makes and runs the simulation of one seed; called on several threads at once. What
   *     it throws is a failed run
   * @throws InterruptedException if the calling thread is interrupted; runs under way are abandoned
   */
  public CampaignResult run(LongFunction<RunOutcome> runner, Progress progress)
      throws InterruptedException {
    Shared shared = new Shared(runner);
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < Math.min(workers, planned()); i++) {
      Thread thread = new Thread(shared::work, "campaign-" + i);
      thread.setDaemon(true);
      threads.add(thread);
    }
    threads.forEach(Thread::start);
    try {
      return collect(shared, threads.size(), progress);
    } finally {
      shared.endIndex.set(0);
    }
  }

  private CampaignResult collect(Shared shared, int running, Progress progress)
      throws InterruptedException {
    Map<Long, RunOutcome> outcomes = new TreeMap<>();
    long bad = 0;
    int left = running;
    while (left > 0) {
      Finished run = shared.finished.take();
      if (run.error() != null) {
        throw run.error();
      }
      RunOutcome outcome = run.outcome();
      if (outcome == null) {
        left--;
      } else {
        outcomes.put(run.seed(), outcome);
        bad += outcome.isGood() ? 0 : 1;
        progress.advanced(outcomes.size(), planned(), bad);
      }
    }
    List<CampaignResult.Run> runs = new ArrayList<>();
    // Runs beyond the first bad one were begun or not, as the threads had it.
    long endIndex = shared.endIndex.get();
    outcomes.forEach((seed, outcome) -> {
      if (seed - firstSeed < endIndex) {
        runs.add(new CampaignResult.Run(seed, outcome));
      }
    });
    return new CampaignResult(runs);
  }

  private long planned() {
    return lastSeed - firstSeed + 1;
  }
}
