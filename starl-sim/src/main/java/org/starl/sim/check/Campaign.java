package org.starl.sim.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/**
 * Many runs with different seeds, on all cores: each thread executes one run at a time, and runs
 * share no state. The result depends only on the seeds.
 *
 * @param firstSeed of the first run
 * @param lastSeed of the last run, not below the first
 * @param workers threads
 * @param stopAtBad whether the campaign ends with the first bad run, in seed order
 */
public record Campaign(long firstSeed, long lastSeed, int workers, boolean stopAtBad) {

  /**
   * Called on the calling thread after each run, even if the result will not include the run, and
   * after each second without one.
   */
  @FunctionalInterface
  public interface Progress {

    /**
     * @param finished runs so far
     * @param planned runs of the whole campaign
     * @param bad number of bad runs so far
     */
    void advanced(long finished, long planned, long bad);

    /** Called before each {@link #advanced} with the seeds whose runs have begun and not ended. */
    default void running(SortedSet<Long> seeds) {}
  }

  public Campaign {
    long planned = lastSeed - firstSeed + 1;
    if (lastSeed < firstSeed || planned <= 0 || planned > Integer.MAX_VALUE) {
      throw new IllegalArgumentException(
          "seeds " + firstSeed + ".." + lastSeed + ": expected the smaller one first, below 2^31");
    }
    if (workers <= 0) {
      throw new IllegalArgumentException(
          "campaign on " + workers + " threads: expected at least one");
    }
  }

  /** All seeds, on all cores. */
  public Campaign(long firstSeed, long lastSeed) {
    this(firstSeed, lastSeed, Runtime.getRuntime().availableProcessors(), false);
  }

  /** The result of one run, or an error that ends the campaign. */
  private record Finished(long seed, @Nullable RunOutcome outcome, @Nullable Error error) {}

  /** State shared by the calling thread and the workers. */
  private final class Shared {
    private final LongFunction<RunOutcome> runner;
    private final AtomicLong nextIndex = new AtomicLong();
    private final AtomicLong endIndex = new AtomicLong(planned());
    private final BlockingQueue<Finished> finished = new LinkedBlockingQueue<>();
    private final Set<Long> running = ConcurrentHashMap.newKeySet();

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
      running.add(seed);
      try {
        return new Finished(seed, runner.apply(seed), null);
      } catch (RuntimeException e) {
        return new Finished(seed, RunOutcome.failed(e), null);
      } catch (Error e) {
        return new Finished(seed, null, e);
      } finally {
        running.remove(seed);
      }
    }
  }

  /**
   * Executes the campaign.
   *
   * @param runner builds and executes the simulation of one seed; called on several threads at
   *     once. An exception is a failed run
   * @throws InterruptedException if the calling thread is interrupted; current runs are abandoned
   */
  public CampaignResult run(LongFunction<RunOutcome> runner, Progress progress)
      throws InterruptedException {
    return run(runner, progress, run -> false);
  }

  /**
   * Executes the campaign until a run decides it.
   *
   * @param isLast called on the calling thread for each run of the result, in seed order, as early
   *     as possible; after the first true the campaign ends
   */
  public CampaignResult run(
      LongFunction<RunOutcome> runner, Progress progress, Predicate<CampaignResult.Run> isLast)
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
      return collect(shared, threads.size(), progress, isLast);
    } finally {
      shared.endIndex.set(0);
    }
  }

  private CampaignResult collect(
      Shared shared, int running, Progress progress, Predicate<CampaignResult.Run> isLast)
      throws InterruptedException {
    Map<Long, RunOutcome> early = new TreeMap<>();
    List<CampaignResult.Run> runs = new ArrayList<>();
    long count = 0;
    long bad = 0;
    int left = running;
    while (left > 0) {
      Finished run = shared.finished.poll(1, TimeUnit.SECONDS);
      progress.running(new TreeSet<>(shared.running));
      if (run == null) {
        progress.advanced(count, planned(), bad);
        continue;
      }
      if (run.error() != null) {
        throw run.error();
      }
      RunOutcome outcome = run.outcome();
      if (outcome == null) {
        left--;
      } else {
        early.put(run.seed(), outcome);
        count++;
        bad += outcome.isGood() ? 0 : 1;
        progress.advanced(count, planned(), bad);
        takeInOrder(early, runs, shared.endIndex, isLast);
      }
    }
    return new CampaignResult(runs);
  }

  /**
   * Moves the next runs in seed order from {@code early} to {@code runs}. The threads' timing
   * decides which runs beyond the last one were started: they do not count.
   */
  private void takeInOrder(
      Map<Long, RunOutcome> early,
      List<CampaignResult.Run> runs,
      AtomicLong endIndex,
      Predicate<CampaignResult.Run> isLast) {
    while (runs.size() < endIndex.get()) {
      long seed = firstSeed + runs.size();
      RunOutcome outcome = early.remove(seed);
      if (outcome == null) {
        return;
      }
      CampaignResult.Run run = new CampaignResult.Run(seed, outcome);
      runs.add(run);
      if (isLast.test(run)) {
        endIndex.accumulateAndGet(runs.size(), Math::min);
      }
    }
  }

  private long planned() {
    return lastSeed - firstSeed + 1;
  }
}
