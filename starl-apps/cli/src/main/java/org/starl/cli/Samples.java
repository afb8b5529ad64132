package org.starl.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.sim.check.CampaignResult;

/** The measures of all runs of a campaign. */
final class Samples {

  private final List<Measures> runs = new ArrayList<>();

  /**
   * @param bySeed measures of the runs that ended without an exception
   */
  Samples(CampaignResult result, BySeed<Measures> bySeed) {
    for (CampaignResult.Run run : result.runs()) {
      Measures measures = bySeed.get(run.seed());
      if (measures != null) {
        runs.add(measures);
      }
    }
  }

  /** Robots that completed their task. */
  long completed() {
    return runs.stream().mapToLong(Measures::completed).sum();
  }

  /** All other counts, over all runs. */
  SortedMap<String, Long> counts() {
    SortedMap<String, Long> sums = new TreeMap<>();
    runs.forEach(run -> run.counts().forEach((what, count) -> sums.merge(what, count, Long::sum)));
    return sums;
  }

  /** A percentile of all waiting times, in ns; 0 if there are none. */
  long waitNs(int percent) {
    long[] waits =
        runs.stream()
            .flatMapToLong(run -> run.waitsNs().stream().mapToLong(Long::longValue))
            .sorted()
            .toArray();
    return Measures.waitNs(waits, percent);
  }
}
