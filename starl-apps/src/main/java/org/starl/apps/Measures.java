package org.starl.apps;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.check.Percentile;
import org.starl.time.Time;

/**
 * Figures of one run of an app, for the sums of a campaign.
 *
 * @param tasks what is counted, in the plural: deliveries, say
 * @param came number of tasks
 * @param completed number of completed tasks
 * @param waitsNs time until each of them was completed, in ns
 * @param figures of the whole run, by name, each finite
 * @param counts by name; a campaign adds them up
 */
public record Measures(
    String tasks,
    int came,
    int completed,
    List<Long> waitsNs,
    SortedMap<String, Double> figures,
    SortedMap<String, Long> counts) {

  public Measures {
    waitsNs = List.copyOf(waitsNs);
    figures = Collections.unmodifiableSortedMap(new TreeMap<>(figures));
    counts = Collections.unmodifiableSortedMap(new TreeMap<>(counts));
  }

  /** Of robots: the task of each is its program. */
  public Measures(
      int came,
      int completed,
      List<Long> waitsNs,
      SortedMap<String, Double> figures,
      SortedMap<String, Long> counts) {
    this("robots", came, completed, waitsNs, figures, counts);
  }

  /** Without counts. */
  public Measures(int came, int completed, List<Long> waitsNs, SortedMap<String, Double> figures) {
    this(came, completed, waitsNs, figures, new TreeMap<>());
  }

  /** Without figures and counts. */
  public Measures(int came, int completed, List<Long> waitsNs) {
    this(came, completed, waitsNs, new TreeMap<>());
  }

  /** The mean of times in ns, in s; 0 if there are none. */
  public static double meanS(List<Long> timesNs) {
    return timesNs.stream().mapToLong(Long::longValue).average().orElse(0) / Time.NS_PER_S;
  }

  /** A percentile of the waits, in ns; 0 if there are none. */
  public static long waitNs(long[] sortedWaitsNs, int percent) {
    int count = sortedWaitsNs.length;
    return count == 0 ? 0 : sortedWaitsNs[Percentile.index(count, percent)];
  }
}
