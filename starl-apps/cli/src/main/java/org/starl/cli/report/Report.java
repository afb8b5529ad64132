package org.starl.cli.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.LongFunction;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Sample;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.CampaignResult.Run;
import org.starl.sim.check.RunOutcome.Verdict;

/**
 * What there is to tell of a campaign. Equal campaigns have equal reports.
 *
 * @param subject what was run
 * @param result how each run ended
 * @param facts of the runs that came to an end, by seed; of those that are in the result
 * @param claims what the lemmas say
 * @param example a run to be looked at where all went well; may be null
 * @param pictured some of the runs that did not go well, told and seen
 * @param shrunk lines about what is left of the first of them; empty if it was not shrunk
 */
public record Report(
    Subject subject,
    CampaignResult result,
    SortedMap<Long, RunFacts> facts,
    Claims claims,
    @Nullable Pictured example,
    List<Pictured> pictured,
    List<String> shrunk) {

  /** Of so many runs that did not go well a page has story and pictures. */
  public static final int MOST_PICTURED = 10;

  public Report {
    facts = new TreeMap<>(facts);
    pictured = List.copyOf(pictured);
    shrunk = List.copyOf(shrunk);
  }

  /** The facts of the runs of {@code result}; {@code bySeed} gives null for those that threw. */
  public static SortedMap<Long, RunFacts> facts(
      CampaignResult result, LongFunction<@Nullable RunFacts> bySeed) {
    SortedMap<Long, RunFacts> facts = new TreeMap<>();
    for (Run run : result.runs()) {
      RunFacts of = bySeed.apply(run.seed());
      if (of != null) {
        facts.put(run.seed(), of);
      }
    }
    return facts;
  }

  /**
   * The runs to be pictured: the first of each way of going wrong, then others, in the order of their
   * seeds.
   */
  public static List<Run> toPicture(CampaignResult result) {
    Set<Run> chosen = new LinkedHashSet<>();
    Set<String> ways = new LinkedHashSet<>();
    List<Run> bad = bad(result);
    for (Run run : bad) {
      if (ways.add(run.outcome().verdict() + " " + run.outcome().what())) {
        chosen.add(run);
      }
    }
    chosen.addAll(bad);
    return chosen.stream()
        .limit(MOST_PICTURED)
        .sorted((a, b) -> Long.compare(a.seed(), b.seed()))
        .toList();
  }

  /** When a run went wrong; beyond its end if that is not known. */
  public static long momentNs(Run run, @Nullable RunFacts facts) {
    if (run.outcome().atNs() >= 0) {
      return run.outcome().atNs();
    }
    return facts == null ? Long.MAX_VALUE : facts.endNs();
  }

  /** The page. */
  public String page() {
    return new Page(this).write();
  }

  static List<Run> bad(CampaignResult result) {
    return result.runs().stream().filter(run -> !run.outcome().isGood()).toList();
  }

  List<Run> bad() {
    return bad(result);
  }

  long count(Verdict verdict) {
    return result.count(verdict);
  }

  /** The messages of all runs. */
  MessageCounts messages() {
    MessageCounts sum = new MessageCounts();
    facts.values().forEach(run -> sum.add(run.messages()));
    return sum;
  }

  /** How often each lemma was checked, over all runs. */
  SortedMap<String, RunFacts.Checks> lemmas() {
    SortedMap<String, RunFacts.Checks> sums = new TreeMap<>();
    facts
        .values()
        .forEach(run ->
            run.lemmas()
                .forEach((lemma, checks) -> sums.merge(lemma, checks, RunFacts.Checks::plus)));
    return sums;
  }

  /** One name's samples, run by run; of a run that has none, none. */
  record Sampled(String name, Sample.Kind kind, String unit, List<List<Double>> runs) {

    boolean isEmpty() {
      return runs.stream().allMatch(List::isEmpty);
    }
  }

  /** In the order in which the runs name them. */
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
