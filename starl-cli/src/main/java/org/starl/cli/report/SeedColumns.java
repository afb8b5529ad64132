package org.starl.cli.report;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;
import org.starl.sim.check.RunOutcome;
import org.starl.time.Time;

/**
 * A run as a row of a flat table, for the tools of others. A value is a {@link Long}, a {@link
 * Double} or a {@link String}; a run has no column for a value that it lacks. Measures have their
 * unit at the end of their name ({@code _s}); those without one are counts.
 */
public final class SeedColumns {

  private SeedColumns() {}

  /** The columns of a row, by name. */
  public static SortedMap<String, Object> of(SeedRow row) {
    RunOutcome outcome = row.outcome();
    SortedMap<String, Object> columns = new TreeMap<>();
    columns.put("seed", row.seed());
    columns.put("verdict", outcome.verdict().toString());
    put(columns, "failure", outcome.what().isEmpty() ? null : outcome.what());
    put(columns, "failure_detail", outcome.detail().isEmpty() ? null : outcome.detail());
    put(columns, "failure_at_s", outcome.atNs() < 0 ? null : Time.seconds(outcome.atNs()));
    columns.put("fault_kinds", String.join(",", row.kinds()));
    outcome.figures().forEach((name, value) -> columns.put(name(name), value));
    outcome.checks().forEach((lemma, count) -> columns.put("checks_" + name(lemma), count));
    if (row.facts() != null) {
      Measures measures = row.facts().measures();
      columns.put("tasks", (long) measures.came());
      columns.put("tasks_completed", (long) measures.completed());
      measures.counts().forEach((name, count) -> columns.put("count_" + name(name), count));
      long[] waits = measures.waitsNs().stream().mapToLong(Long::longValue).sorted().toArray();
      for (int percent : List.of(50, 95, 100)) {
        Double wait = waits.length == 0 ? null : Time.seconds(Measures.waitNs(waits, percent));
        put(columns, "wait_p" + percent + "_s", wait);
      }
    }
    return columns;
  }

  /** A name that every tool takes without quotes: letters, digits and underscores. */
  public static String name(String text) {
    return text.replaceAll("[^A-Za-z0-9]+", "_");
  }

  private static void put(SortedMap<String, Object> columns, String name, @Nullable Object value) {
    if (value != null) {
      columns.put(name, value);
    }
  }
}
