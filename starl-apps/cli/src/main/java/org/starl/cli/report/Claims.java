package org.starl.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Plan;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;

/** What the lemmas that a run is checked by say, in words. */
public final class Claims {

  /**
   * A lemma of one monitor; others may have one of that name.
   *
   * @param monitor its class; may be empty
   * @param text a sentence; may be empty
   */
  record Claim(String monitor, String text) {}

  private final SortedMap<String, List<Claim>> byLemma = new TreeMap<>();

  private Claims() {}

  /** Those of the monitors of {@code plan}, which is used up. */
  public static Claims of(Plan plan) {
    Claims claims = new Claims();
    for (Monitor monitor : Monitors.of(plan.simulation().build().plan().monitors()).monitors()) {
      for (String lemma : monitor.lemmas()) {
        List<Claim> known = claims.byLemma.computeIfAbsent(lemma, any -> new ArrayList<>());
        Claim claim = new Claim(monitor.getClass().getSimpleName(), monitor.description(lemma));
        if (!known.contains(claim)) {
          known.add(claim);
        }
      }
    }
    return claims;
  }

  List<Claim> of(String lemma) {
    return byLemma.getOrDefault(lemma, List.of());
  }
}
