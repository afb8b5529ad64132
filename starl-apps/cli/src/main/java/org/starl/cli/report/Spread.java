package org.starl.cli.report;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.starl.sim.check.Percentile;

/** Many values, in order. */
final class Spread {

  /** Beyond so many times the 99th percentile, stragglers would squeeze everything else. */
  private static final double STRAGGLES = 1.6;

  private static final int FEW = 20;

  private final double[] sorted;

  private Spread(double[] sorted) {
    this.sorted = sorted;
  }

  static Spread of(Collection<Double> values) {
    return ofAll(List.of(values));
  }

  static Spread ofAll(Collection<? extends Collection<Double>> parts) {
    double[] all =
        parts.stream().flatMap(Collection::stream).mapToDouble(Double::doubleValue).toArray();
    Arrays.sort(all);
    return new Spread(all);
  }

  int count() {
    return sorted.length;
  }

  boolean isEmpty() {
    return sorted.length == 0;
  }

  /** See {@link Percentile}. */
  double percentile(double percent) {
    return sorted[Percentile.index(sorted.length, percent)];
  }

  double least() {
    return sorted[0];
  }

  double most() {
    return sorted[sorted.length - 1];
  }

  double mean() {
    double sum = 0;
    for (double value : sorted) {
      sum += value;
    }
    return sum / sorted.length;
  }

  /** How many lie at or below {@code limit}. */
  int upTo(double limit) {
    int from = 0;
    int to = sorted.length;
    while (from < to) {
      int middle = (from + to) >>> 1;
      if (sorted[middle] <= limit) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from;
  }

  /** How many lie below {@code limit}. */
  int below(double limit) {
    return upTo(Math.nextDown(limit));
  }

  /** Up to where a chart shows the values: all of them, but for a few far stragglers. */
  double shownUpTo() {
    double most = percentile(99);
    return count() >= FEW && most > 0 && most() > STRAGGLES * most ? most : most();
  }
}
