package org.starl.cli.report;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.starl.sim.check.Percentile;

/** Values in ascending order. */
final class Distribution {

  /** Charts leave out values if the maximum is above the 99th percentile by this factor. */
  private static final double OUTLIER_FACTOR = 1.6;

  private static final int MIN_COUNT = 20;

  private final double[] sorted;

  private Distribution(double[] sorted) {
    this.sorted = sorted;
  }

  static Distribution of(Collection<Double> values) {
    return ofAll(List.of(values));
  }

  static Distribution ofAll(Collection<? extends Collection<Double>> parts) {
    double[] all =
        parts.stream().flatMap(Collection::stream).mapToDouble(Double::doubleValue).toArray();
    Arrays.sort(all);
    return new Distribution(all);
  }

  /** All values, ascending. */
  List<Double> all() {
    return Arrays.stream(sorted).boxed().toList();
  }

  int count() {
    return sorted.length;
  }

  /** See {@link Percentile}. */
  double percentile(double percent) {
    return sorted[Percentile.index(sorted.length, percent)];
  }

  double minimum() {
    return sorted[0];
  }

  double maximum() {
    return sorted[sorted.length - 1];
  }

  double mean() {
    return Arrays.stream(sorted).sum() / sorted.length;
  }

  /** The number of values at or below {@code limit}. */
  int upTo(double limit) {
    return (int) Arrays.stream(sorted).takeWhile(value -> value <= limit).count();
  }

  /** The number of values below {@code limit}. */
  int below(double limit) {
    return upTo(Math.nextDown(limit));
  }

  /** The largest value that a chart shows: the maximum, or less if there are a few far outliers. */
  double chartLimit() {
    double high = percentile(99);
    boolean hasOutliers = count() >= MIN_COUNT && high > 0 && maximum() > OUTLIER_FACTOR * high;
    return hasOutliers ? high : maximum();
  }
}
