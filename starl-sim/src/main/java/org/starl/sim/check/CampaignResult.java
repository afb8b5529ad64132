package org.starl.sim.check;

import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.RunOutcome.Verdict;

/**
 * The result of a campaign: the runs in seed order. Equal campaigns have equal results for any
 * number of threads.
 */
public record CampaignResult(List<Run> runs) {

  private static final int ENOUGH = 100;

  /** One run and its seed. */
  public record Run(long seed, RunOutcome outcome) {}

  public CampaignResult {
    runs = List.copyOf(runs);
  }

  /** The first bad run in seed order, or null. */
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

  /** The lemmas that some run had to check and no run has checked: they are not held, but unknown. */
  public SortedSet<String> neverChecked() {
    SortedMap<String, Long> checks = new TreeMap<>();
    runs.forEach(run ->
        run.outcome().checks().forEach((lemma, times) -> checks.merge(lemma, times, Long::sum)));
    return neverChecked(checks);
  }

  /** The lemmas of {@code checks}, a number for each lemma, that were checked 0 times. */
  public static SortedSet<String> neverChecked(SortedMap<String, Long> checks) {
    SortedSet<String> lemmas = new TreeSet<>(checks.keySet());
    lemmas.removeIf(lemma -> checks.getOrDefault(lemma, 0L) > 0);
    return lemmas;
  }

  /**
   * Whether the campaign fails because of {@link #neverChecked}: only one of {@value #ENOUGH} runs or
   * more, since in a smaller one that may be chance.
   */
  public boolean leavesUnchecked() {
    return leavesUnchecked(runs.size(), neverChecked());
  }

  /** As {@link #leavesUnchecked()}, for this number of runs and these lemmas. */
  public static boolean leavesUnchecked(long runs, SortedSet<String> neverChecked) {
    return runs >= ENOUGH && !neverChecked.isEmpty();
  }

  /** The names of all figures of all runs, in order. */
  public SortedSet<String> figures() {
    SortedSet<String> names = new TreeSet<>();
    runs.forEach(run -> names.addAll(run.outcome().figures().keySet()));
    return names;
  }

  /** Number of runs that have this figure. */
  public int samples(String figure) {
    return sorted(figure).length;
  }

  /**
   * A percentile of this figure: see {@link Percentile}.
   *
   * @throws IllegalArgumentException if no run has this figure, or percent is not from 0 to 100
   */
  public double percentile(String figure, double percent) {
    double[] samples = sorted(figure);
    if (samples.length == 0) {
      throw new IllegalArgumentException("0 samples of '" + figure + "'");
    }
    return samples[Percentile.index(samples.length, percent)];
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
