package org.starl.sim.check;

/** Percentiles by nearest rank. */
public final class Percentile {

  private Percentile() {}

  /**
   * The index, among {@code count} sorted samples, of the smallest one that is not below {@code
   * percent} of all: 0 gives the minimum, 50 the median, 100 the maximum.
   *
   * @throws IllegalArgumentException if there is no sample, or percent is not from 0 to 100
   */
  public static int index(int count, double percent) {
    return (int) rank(count, percent) - 1;
  }

  /** As {@link #index}, counted from 1. */
  static long rank(long count, double percent) {
    if (count <= 0 || !(percent >= 0 && percent <= 100)) {
      throw new IllegalArgumentException("percentile " + percent + " of " + count + " samples");
    }
    return Math.max((long) Math.ceil(percent * count / 100), 1);
  }
}
