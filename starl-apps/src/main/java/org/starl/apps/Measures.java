package org.starl.apps;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.sim.check.Percentile;

/**
 * One run of an app in numbers that add up over a campaign.
 *
 * @param came how many robots had something to do
 * @param completed how many of them did it
 * @param waitsNs how long each of them waited for it, in ns
 * @param figures of the run as a whole, by name, each finite
 * @param counts of what adds up over runs, by name
 */
public record Measures(
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

  /** Without counts. */
  public Measures(int came, int completed, List<Long> waitsNs, SortedMap<String, Double> figures) {
    this(came, completed, waitsNs, figures, new TreeMap<>());
  }

  /** Without figures of its own. */
  public Measures(int came, int completed, List<Long> waitsNs) {
    this(came, completed, waitsNs, new TreeMap<>());
  }

  /** A percentile of the waits, in ns; 0 if there are none. */
  public static long waitNs(long[] sortedWaitsNs, int percent) {
    int count = sortedWaitsNs.length;
    return count == 0 ? 0 : sortedWaitsNs[Percentile.index(count, percent)];
  }
}
