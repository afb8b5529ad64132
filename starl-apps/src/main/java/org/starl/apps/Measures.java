package org.starl.apps;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

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

  /** No more than so many percent of the waits are shorter; 0 if nobody waited. */
  public static long waitNs(long[] sortedWaitsNs, int percent) {
    if (sortedWaitsNs.length == 0) {
      return 0;
    }
    int rank = (int) Math.ceil(percent * (double) sortedWaitsNs.length / 100);
    return sortedWaitsNs[Math.max(rank, 1) - 1];
  }
}
