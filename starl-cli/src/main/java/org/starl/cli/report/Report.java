package org.starl.cli.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Sample;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.spec.Monitor;

/**
 * The contents of a campaign's report page. Equal campaigns have equal reports.
 *
 * @param description the campaign's app, seeds and settings
 * @param result how each run ended
 * @param facts facts of the runs that ended without an exception, by seed
 * @param chances the bad runs, over all runs and for each kind of fault
 * @param coverage what the runs reached
 * @param monitors that checked each run
 * @param example a run to show where all runs went well; may be null
 * @param illustrated some of the bad runs, with stories and pictures
 * @param shrunk lines about the shrunk first bad run; empty if it was not shrunk
 * @param steered lines about the steered runs; empty if there were none
 * @param steeredReplay the command of the first bad steered run; empty if there was none
 */
public record Report(
    CampaignDescription description,
    CampaignResult result,
    SortedMap<Long, RunFacts> facts,
    Chances chances,
    Coverage coverage,
    List<Monitor> monitors,
    @Nullable IllustratedRun example,
    List<IllustratedRun> illustrated,
    List<String> shrunk,
    List<String> steered,
    String steeredReplay) {

  /** At most this many bad runs have a story and pictures on the page. */
  public static final int MAX_ILLUSTRATED = 10;

  /**
   * Keeps only the facts of the runs of {@code result}: others ran after the first bad run.
   */
  public Report {
    facts = facts.headMap(result.runs().getLast().seed() + 1);
  }

  /**
   * The runs to illustrate, ordered by seed: the first bad run of each kind, then further bad runs
   * up to {@link #MAX_ILLUSTRATED}.
   */
  public static List<Run> toIllustrate(CampaignResult result) {
    Set<Run> runs = new LinkedHashSet<>();
    Set<String> kinds = new LinkedHashSet<>();
    List<Run> bad = bad(result);
    for (Run run : bad) {
      if (kinds.add(run.outcome().verdict() + " " + run.outcome().what())) {
        runs.add(run);
      }
    }
    runs.addAll(bad);
    return runs.stream()
        .limit(MAX_ILLUSTRATED)
        .sorted(Comparator.comparingLong(Run::seed))
        .toList();
  }

  /** The time of a run's problem; after its end if that time is unknown. */
  public static long momentNs(Run run, @Nullable RunFacts facts) {
    if (run.outcome().atNs() >= 0) {
      return run.outcome().atNs();
    }
    return facts == null ? Long.MAX_VALUE : facts.endNs();
  }

  /** What monitors say of {@code lemma}: no sentence, or one for each monitor that has this lemma. */
  List<String> descriptions(String lemma) {
    return monitors.stream()
        .filter(monitor -> monitor.lemmas().contains(lemma))
        .map(monitor -> monitor.description(lemma))
        .filter(text -> !text.isEmpty())
        .distinct()
        .toList();
  }

  List<Run> bad() {
    return bad(result);
  }

  private static List<Run> bad(CampaignResult result) {
    return result.runs().stream().filter(run -> !run.outcome().isGood()).toList();
  }

  Totals totals() {
    return new Totals(facts.values().stream().map(RunFacts::measures).toList());
  }

  /** The messages of all runs. */
  MessageCounts messages() {
    MessageCounts sum = new MessageCounts();
    facts.values().forEach(run -> sum.add(run.messages()));
    return sum;
  }

  /** Checks and violations of each lemma, over all runs. */
  SortedMap<String, RunFacts.Checks> lemmas() {
    SortedMap<String, RunFacts.Checks> sums = new TreeMap<>();
    for (RunFacts run : facts.values()) {
      run.lemmas().forEach((lemma, checks) -> sums.merge(lemma, checks, RunFacts.Checks::plus));
    }
    return sums;
  }

  /** The samples of one name, a list for each run that has them. */
  record Sampled(String name, Sample.Kind kind, String unit, List<List<Double>> runs) {

    boolean isEmpty() {
      return runs.stream().allMatch(List::isEmpty);
    }
  }

  /** Ordered by their first occurrence in the runs. */
  List<Sampled> samples() {
    Map<String, Sampled> byName = new LinkedHashMap<>();
    for (RunFacts run : facts.values()) {
      for (Sample sample : run.samples()) {
        byName
            .computeIfAbsent(
                sample.kind() + " " + sample.name(),
                any -> new Sampled(sample.name(), sample.kind(), sample.unit(), new ArrayList<>()))
            .runs()
            .add(sample.values());
      }
    }
    return List.copyOf(byName.values());
  }
}
