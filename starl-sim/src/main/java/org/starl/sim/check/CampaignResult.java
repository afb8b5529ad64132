package org.starl.sim.check;

import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.RunOutcome.Verdict;

/**
 * What came of a campaign: the runs in the order of their seeds. Equal campaigns have equal results,
 * however many threads ran them.
 */
public record CampaignResult(List<Run> runs) {

  /** One run, by its seed. */
  public record Run(long seed, RunOutcome outcome) {}

  public CampaignResult {
    runs = List.copyOf(runs);
  }

  /** The run with the first seed that did not go well, or null. */
  public @Nullable Run firstBad() {
    for (Run run : runs) {
      if (!run.outcome().isGood()) {
        return run;
      }
    }
    return null;
  }

  public long count(Verdict verdict) {
    return runs.stream().filter(run -> run.outcome().verdict() == verdict).count();
  }

  /** The names of all figures of all runs, in order. */
  public SortedSet<String> figures() {
    SortedSet<String> names = new TreeSet<>();
    runs.forEach(run -> names.addAll(run.outcome().figures().keySet()));
    return names;
  }

  /** How many runs have this figure. */
  public int samples(String figure) {
    return sorted(figure).length;
  }

  /**
   * The smallest sample that is not below {@code percent} of all samples (nearest rank): 0 gives the
   * least, 50 the median, 100 the greatest.
   *
   * @throws IllegalArgumentException if no run has this figure, or percent is not from 0 to 100
   */
  public double percentile(String figure, double percent) {
    double[] samples = sorted(figure);
    if (samples.length == 0 || !(percent >= 0 && percent <= 100)) {
      throw new IllegalArgumentException(
          "percentile " + percent + " of " + samples.length + " samples of '" + figure + "'");
    }
    int rank = (int) Math.ceil(percent * samples.length / 100);
    return samples[Math.max(rank, 1) - 1];
  }

  private double[] sorted(String figure) {
    double[] samples = new double[runs.size()];
    int n = 0;
    for (Run run : runs) {
      Double value = run.outcome().figures().get(figure);
      if (value != null) {
        samples[n++] = value;
      }
    }
    samples = Arrays.copyOf(samples, n);
    Arrays.sort(samples);
    return samples;
  }
}
