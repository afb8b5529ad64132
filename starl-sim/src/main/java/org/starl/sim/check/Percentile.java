package org.starl.sim.check;

/**
 * Exact percentiles by nearest rank. No histogram is needed, because all samples of a campaign are
 * in memory.
 */
public final class Percentile {

  private Percentile() {}

  /**
   * The index, among {@code count} sorted samples, of the smallest one that is not below {@code
   * percent} of all: 0 gives the minimum, 50 the median, 100 the maximum.
   *
   * @throws IllegalArgumentException if there is no sample, or percent is not from 0 to 100
   */
  public static int index(int count, double percent) {
    if (count <= 0 || !(percent >= 0 && percent <= 100)) {
      throw new IllegalArgumentException("percentile " + percent + " of " + count + " samples");
    }
    return Math.max((int) Math.ceil(percent * count / 100), 1) - 1;
  }
}
