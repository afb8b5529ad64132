package org.starl.sim.check;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.random.Rng;
import org.starl.sim.Redraws;

/**
 * Estimates the probability of rare bad runs by splitting (Kahn and Harris 1951; with a fixed factor:
 * Glasserman, Heidelberger, Shahabuddin, Zajic, "Multilevel splitting for estimating rare event
 * probabilities", Operations Research 47, 1999).
 *
 * <p>A run that reaches a level goes on as {@code copies} runs, which have the same past and draw
 * their future anew ({@link Redraws}). Each counts for {@code 1 / copies} of the run, so the expected
 * sum of a seed's bad runs is the probability that a run is bad, whatever the levels are: only the
 * variance depends on them.
 *
 * @param levels the number of levels, at least 1
 * @param copies runs for each run that reaches a level, at least 2
 */
public record Splitting(int levels, int copies) {

  /** The most runs that a seed may need. */
  public static final long MOST_RUNS = 100_000;

  /**
   * One run.
   *
   * @param atNs when it reached each level, up to the first violation, in ns of virtual time: not
   *     decreasing, and decided by nothing that happened later
   */
  public record Sample(RunOutcome outcome, List<Long> atNs) {

    public Sample {
      atNs = List.copyOf(atNs);
    }
  }

  /** Executes the run of a seed that is drawn anew at some times. */
  @FunctionalInterface
  public interface Runner {
    Sample run(long seed, Redraws redraws);
  }

  /** A bad run. */
  public record Bad(Redraws redraws, RunOutcome outcome) {}

  /**
   * The runs of one seed.
   *
   * @param bad the sum of the shares of its bad runs, from 0 to 1
   * @param levels how many levels its first run and the copies of it reached
   * @param first the first bad run, or null
   */
  public record Tree(double bad, long runs, int levels, @Nullable Bad first) {}

  public Splitting {
    if (levels < 1 || copies < 2 || StrictMath.pow(copies, levels) > MOST_RUNS) {
      throw new IllegalArgumentException(
          levels
              + " levels, "
              + copies
              + " copies: expected at least 1 and 2, and at most "
              + MOST_RUNS
              + " runs of a seed");
    }
  }

  /** Executes the runs of a seed, one after the other. */
  public Tree run(long seed, Runner runner) {
    Growth growth = new Growth(seed, runner);
    growth.grow(Redraws.NONE, 0, 1);
    return new Tree(growth.bad, growth.runs, growth.most, growth.first);
  }

  private final class Growth {
    private final long seed;
    private final Runner runner;
    private final Rng numbers;
    private double bad;
    private long runs;
    private int most;
    private @Nullable Bad first;

    Growth(long seed, Runner runner) {
      this.seed = seed;
      this.runner = runner;
      numbers = new Rng(seed).fork("splitting");
    }

    /**
     * @param from the first level at which this run splits: it shares the earlier ones with others
     * @param share of the run, before it splits
     */
    void grow(Redraws redraws, int from, double share) {
      Sample sample = runner.run(seed, redraws);
      List<Long> atNs = sample.atNs();
      runs++;
      most = Math.max(most, atNs.size());
      double own = share;
      List<Redraws> copied = new ArrayList<>();
      for (int level = from; level < atNs.size(); level++) {
        own /= copies;
        for (int copy = 1; copy < copies; copy++) {
          // After all events of that time: the copies have them in common.
          long number = numbers.nextLong() >>> 1;
          copied.add(redraws.plus(new Redraws.One(atNs.get(level) + 1, number)));
        }
      }
      if (!sample.outcome().isGood()) {
        bad += own;
        first = first == null ? new Bad(redraws, sample.outcome()) : first;
      }
      double copyShare = share;
      for (int i = 0; i < copied.size(); i++) {
        int level = from + i / (copies - 1);
        copyShare = i % (copies - 1) == 0 ? copyShare / copies : copyShare;
        grow(copied.get(i), level + 1, copyShare);
      }
    }
  }
}
