package org.starl.sim.view;

/** The rate of a counter, averaged over about the last second. */
final class Meter {

  private static final long SPAN_NS = 500_000_000;
  private static final double NS_PER_S = 1e9;

  private long sinceNs = Long.MIN_VALUE;
  private long sinceCount;
  private double rate;

  /**
   * Sets the current count.
   *
   * @param realNs of any clock that goes on
   */
  void read(long realNs, long count) {
    if (sinceNs == Long.MIN_VALUE || count < sinceCount) {
      sinceNs = realNs;
      sinceCount = count;
    } else if (realNs - sinceNs >= SPAN_NS) {
      rate = (count - sinceCount) * NS_PER_S / (realNs - sinceNs);
      sinceNs = realNs;
      sinceCount = count;
    }
  }

  double perSecond() {
    return rate;
  }
}
