package org.starl.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Reached;

/**
 * What the runs of a campaign reached of the theories: each action of the automata, and each
 * conjunct of their guards that was false for an action that was taken at another time. Used by
 * several threads.
 */
public final class Coverage {

  /** One action of a theory. */
  private static final class Row {
    private long taken;
    private final SortedSet<String> falseGuards = new TreeSet<>();
  }

  private final SortedMap<String, SortedMap<String, Row>> theories = new TreeMap<>();

  /** Adds a run. */
  public synchronized void add(SpecReport report) {
    for (Map.Entry<Reached, Long> entry : report.reached().entrySet()) {
      Reached reached = entry.getKey();
      SortedMap<String, Row> rows =
          theories.computeIfAbsent(reached.theory(), any -> rows(reached.action()));
      Row row = rows.computeIfAbsent(reached.action().getSimpleName(), any -> new Row());
      if (reached.guard().isEmpty()) {
        row.taken += entry.getValue();
      } else {
        row.falseGuards.add(reached.guard());
      }
    }
  }

  /** A row for each action of the theory of {@code action}, which is one of a sealed interface. */
  private static SortedMap<String, Row> rows(Class<?> action) {
    SortedMap<String, Row> rows = new TreeMap<>();
    for (Class<?> type : action.getInterfaces()) {
      if (type.isSealed()) {
        for (Class<?> other : type.getPermittedSubclasses()) {
          rows.put(other.getSimpleName(), new Row());
        }
      }
    }
    return rows;
  }

  /** A line for each theory; none without a theory. */
  public synchronized List<String> lines() {
    List<String> lines = new ArrayList<>();
    theories.forEach((theory, rows) -> {
      long taken = rows.values().stream().filter(row -> row.taken > 0).count();
      int guards = rows.values().stream().mapToInt(row -> row.falseGuards.size()).sum();
      List<String> never =
          rows.entrySet().stream()
              .filter(row -> row.getValue().taken == 0)
              .map(Map.Entry::getKey)
              .toList();
      lines.add(
          "coverage of %s: %d of %d actions, %d guards seen false%s"
              .formatted(
                  theory,
                  taken,
                  rows.size(),
                  guards,
                  never.isEmpty() ? "" : "; never: " + String.join(" ", never)));
    });
    return lines;
  }
}
