package org.starl.sim.check;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Percentiles of any number of samples in bounded memory. They are exact up to {@link #MAX_EXACT}
 * different values. With more values, each sample is rounded towards 0 to {@link #KEPT_BITS} bits
 * after the leading one, which changes it by less than 1 in 4096; the maximum stays exact. The
 * percentiles depend only on the samples, not on their order.
 */
public final class Histogram {

  /** The largest number of different values that are kept as they are. */
  static final int MAX_EXACT = 1 << 15;

  static final int KEPT_BITS = 12;

  private static final int MANTISSA_BITS = 52;

  private SortedMap<Double, Long> counts = new TreeMap<>();
  private long size;
  private double maximum = Double.NEGATIVE_INFINITY;
  private boolean isRounded;

  /**
   * Adds a sample.
   *
   * @throws IllegalArgumentException if it is not finite
   */
  public void add(double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("sample " + value + ": expected a finite number");
    }
    counts.merge(isRounded ? rounded(value) : value, 1L, Long::sum);
    size++;
    maximum = Math.max(maximum, value);
    if (!isRounded && counts.size() > MAX_EXACT) {
      isRounded = true;
      SortedMap<Double, Long> exact = counts;
      counts = new TreeMap<>();
      exact.forEach((key, count) -> counts.merge(rounded(key), count, Long::sum));
    }
  }

  /** The number of samples. */
  public long size() {
    return size;
  }

  /**
   * A percentile: see {@link Percentile}.
   *
   * @throws IllegalArgumentException if there is no sample, or percent is not from 0 to 100
   */
  public double percentile(double percent) {
    long rank = Percentile.rank(size, percent);
    if (rank == size) {
      return maximum;
    }
    long below = 0;
    for (Map.Entry<Double, Long> entry : counts.entrySet()) {
      below += entry.getValue();
      if (below >= rank) {
        return entry.getKey();
      }
    }
    throw new IllegalStateException(size + " samples, counted " + below);
  }

  private static double rounded(double value) {
    long bits = Double.doubleToRawLongBits(value);
    return Double.longBitsToDouble(bits & (-1L << (MANTISSA_BITS - KEPT_BITS)));
  }
}
