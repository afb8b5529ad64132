package org.starl.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.sim.check.CampaignResult;

/** What the runs of a campaign measured, those that count. */
final class Samples {

  private final List<Measures> runs = new ArrayList<>();

  /**
   * @param bySeed of the runs that came to an end
   */
  Samples(CampaignResult result, BySeed<Measures> bySeed) {
    for (CampaignResult.Run run : result.runs()) {
      Measures measures = bySeed.get(run.seed());
      if (measures != null) {
        runs.add(measures);
      }
    }
  }

  /** Robots that did what they came for. */
  long completed() {
    return runs.stream().mapToLong(Measures::completed).sum();
  }

  /** Whatever else was counted, over all runs. */
  SortedMap<String, Long> counts() {
    SortedMap<String, Long> sums = new TreeMap<>();
    runs.forEach(run -> run.counts().forEach((what, count) -> sums.merge(what, count, Long::sum)));
    return sums;
  }

  /** A percentile of all waits, in ns; 0 if there are none. */
  long waitNs(int percent) {
    long[] waits =
        runs.stream()
            .flatMapToLong(run -> run.waitsNs().stream().mapToLong(Long::longValue))
            .sorted()
            .toArray();
    return Measures.waitNs(waits, percent);
  }
}
