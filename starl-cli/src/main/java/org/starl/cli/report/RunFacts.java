package org.starl.cli.report;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.sim.SimResult;
import org.starl.sim.net.NetStatistics;
import org.starl.spec.SpecReport;

/**
 * The facts that a report keeps of one run that ended without an exception; a few kilobytes.
 *
 * @param lemmas checks of each lemma, by its name
 * @param violations the first few violations, as text
 * @param violated number of all violations
 */
public record RunFacts(
    Measures measures,
    List<Sample> samples,
    MessageCounts messages,
    NetStatistics network,
    SortedMap<String, Checks> lemmas,
    List<String> violations,
    long violated,
    long endNs) {

  private static final int KEPT_VIOLATIONS = 8;

  /** How often a lemma was checked and violated. */
  record Checks(long checks, long violations) {

    Checks plus(Checks other) {
      return new Checks(checks + other.checks, violations + other.violations);
    }
  }

  /**
   * The facts of a run that has ended.
   *
   * @param messages an observer of the run
   */
  public static RunFacts of(SimResult result, Story story, MessageCounts messages) {
    SpecReport spec = result.spec();
    SortedMap<String, Checks> lemmas = new TreeMap<>();
    long violated = 0;
    for (String lemma : spec.lemmas()) {
      lemmas.put(lemma, new Checks(spec.checks(lemma), spec.violations(lemma)));
      violated += spec.violations(lemma);
    }
    return new RunFacts(
        story.measures(),
        story.samples(),
        messages,
        result.network(),
        lemmas,
        spec.violations().stream().limit(KEPT_VIOLATIONS).map(String::valueOf).toList(),
        violated,
        result.endNs());
  }
}
