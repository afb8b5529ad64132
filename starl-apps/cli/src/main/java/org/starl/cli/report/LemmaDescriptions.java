package org.starl.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Plan;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;

/** The lemmas that a run is checked against, in words. */
public final class LemmaDescriptions {

  /**
   * A lemma of one monitor. Other monitors may have a lemma of the same name.
   *
   * @param monitor its class; may be empty
   * @param text a sentence; may be empty
   */
  record Description(String monitor, String text) {}

  private final SortedMap<String, List<Description>> byLemma = new TreeMap<>();

  private LemmaDescriptions() {}

  /** The lemmas of the monitors of {@code plan}. The plan cannot be run afterwards. */
  public static LemmaDescriptions of(Plan plan) {
    LemmaDescriptions result = new LemmaDescriptions();
    for (Monitor monitor : Monitors.of(plan.simulation().build().plan().monitors()).monitors()) {
      for (String lemma : monitor.lemmas()) {
        List<Description> known = result.byLemma.computeIfAbsent(lemma, any -> new ArrayList<>());
        Description description =
            new Description(monitor.getClass().getSimpleName(), monitor.description(lemma));
        if (!known.contains(description)) {
          known.add(description);
        }
      }
    }
    return result;
  }

  List<Description> of(String lemma) {
    return byLemma.getOrDefault(lemma, List.of());
  }
}
