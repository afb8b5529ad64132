package org.starl.cli.campaign;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;
import org.starl.cli.report.Chances;
import org.starl.cli.report.Coverage;
import org.starl.cli.report.RareParts;
import org.starl.cli.report.SeedRow;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.Histogram;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;

/** The sums over the runs of a campaign, in memory that does not depend on the number of runs. */
final class CampaignTally {

  private final SortedMap<Verdict, Long> verdicts = new TreeMap<>();
  private final SortedMap<String, Long> counts = new TreeMap<>();
  private final SortedMap<String, Long> checks = new TreeMap<>();
  private final SortedMap<String, Histogram> figures = new TreeMap<>();
  private final SortedSet<String> violated = new TreeSet<>();
  private final Histogram waitsNs = new Histogram();
  private final Chances chances = new Chances();
  private final Coverage coverage = new Coverage();
  private final RareParts rareParts = new RareParts();
  private final boolean mayBeSteered;
  private long runs;
  private String tasks = "robots";
  private long completed;
  private @Nullable SeedRow firstBad;

  /**
   * @param mayBeSteered whether {@link SteeredRuns} may ask for the {@link #rareParts}
   */
  CampaignTally(boolean mayBeSteered) {
    this.mayBeSteered = mayBeSteered;
  }

  /** Adds the next run in seed order. */
  void add(SeedRow row) {
    RunOutcome outcome = row.outcome();
    runs++;
    verdicts.merge(outcome.verdict(), 1L, Long::sum);
    chances.add(row.kinds(), outcome.isGood());
    if (firstBad == null && !outcome.isGood()) {
      firstBad = row;
    }
    if (outcome.verdict() == Verdict.VIOLATED) {
      violated.add(outcome.what());
    }
    outcome.checks().forEach((lemma, times) -> checks.merge(lemma, times, Long::sum));
    outcome
        .figures()
        .forEach((name, value) -> figures.computeIfAbsent(name, any -> new Histogram()).add(value));
    if (row.facts() != null) {
      Measures measures = row.facts().measures();
      tasks = measures.tasks();
      completed += measures.completed();
      measures.counts().forEach((name, count) -> counts.merge(name, count, Long::sum));
      measures.waitsNs().forEach(waitsNs::add);
    }
    if (row.coverage() != null) {
      coverage.add(row.coverage());
      if (mayBeSteered) {
        rareParts.add(row.seed(), row.coverage());
      }
    }
  }

  long runs() {
    return runs;
  }

  long count(Verdict verdict) {
    return verdicts.getOrDefault(verdict, 0L);
  }

  /** The number of bad runs. */
  long bad() {
    return runs - count(Verdict.GOOD);
  }

  /** The first bad run in seed order, or null. */
  @Nullable SeedRow firstBad() {
    return firstBad;
  }

  /** The lemmas that a run violated first, a new set. */
  SortedSet<String> violated() {
    return new TreeSet<>(violated);
  }

  /** What {@link #completed} counts. */
  String tasks() {
    return tasks;
  }

  /** Completed tasks. */
  long completed() {
    return completed;
  }

  /** All other counts, by name. */
  SortedMap<String, Long> counts() {
    return Collections.unmodifiableSortedMap(counts);
  }

  /** These percentiles of all waiting times, in ns; empty if nothing waited. */
  SortedMap<Integer, Long> waitsNs(Collection<Integer> percents) {
    SortedMap<Integer, Long> all = new TreeMap<>();
    if (waitsNs.size() > 0) {
      percents.forEach(percent -> all.put(percent, (long) waitsNs.percentile(percent)));
    }
    return all;
  }

  /** The names of all figures of all runs, in order. */
  SortedSet<String> figures() {
    return new TreeSet<>(figures.keySet());
  }

  double percentile(String figure, int percent) {
    Histogram histogram = figures.get(figure);
    if (histogram == null) {
      throw new IllegalArgumentException("no run has the figure " + figure);
    }
    return histogram.percentile(percent);
  }

  /** See {@link CampaignResult#neverChecked()}. */
  SortedSet<String> neverChecked() {
    return CampaignResult.neverChecked(checks);
  }

  /** See {@link CampaignResult#leavesUnchecked()}. */
  boolean leavesUnchecked() {
    return CampaignResult.leavesUnchecked(runs, neverChecked());
  }

  Chances chances() {
    return chances;
  }

  Coverage coverage() {
    return coverage;
  }

  /** What few runs reached; empty if no run is steered. */
  RareParts rareParts() {
    return rareParts;
  }
}
