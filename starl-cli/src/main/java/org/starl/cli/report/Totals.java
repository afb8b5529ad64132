package org.starl.cli.report;

import java.util.Collection;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;

/** Sums over the runs of a campaign that ended without an exception. */
public final class Totals {

  private final List<Measures> runs;
  private final long[] waitsNs;

  public Totals(Collection<Measures> runs) {
    this.runs = List.copyOf(runs);
    waitsNs =
        runs.stream()
            .flatMap(run -> run.waitsNs().stream())
            .mapToLong(Long::longValue)
            .sorted()
            .toArray();
  }

  long came() {
    return runs.stream().mapToLong(Measures::came).sum();
  }

  /** What {@link #completed} counts; of no run, robots. */
  String tasks() {
    return runs.isEmpty() ? "robots" : runs.getFirst().tasks();
  }

  /** Completed tasks. */
  public long completed() {
    return runs.stream().mapToLong(Measures::completed).sum();
  }

  /** All other counts, by name. */
  public SortedMap<String, Long> counts() {
    SortedMap<String, Long> sums = new TreeMap<>();
    runs.forEach(run -> run.counts().forEach((name, count) -> sums.merge(name, count, Long::sum)));
    return sums;
  }

  boolean hasWaits() {
    return waitsNs.length > 0;
  }

  /** A percentile of all waiting times, in ns; 0 if there are none. */
  public long waitNs(int percent) {
    return Measures.waitNs(waitsNs, percent);
  }
}
