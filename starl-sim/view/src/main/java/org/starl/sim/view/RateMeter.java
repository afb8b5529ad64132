package org.starl.sim.view;

import org.starl.time.Time;

/** Measures the rate of a counter over at least half a second. */
final class RateMeter {

  private static final long SPAN_NS = Time.NS_PER_S / 2;

  private long sinceNs = Long.MIN_VALUE;
  private long sinceCount;
  private double rate;

  /**
   * Takes a reading of the counter.
   *
   * @param realNs time of a monotonic clock
   */
  void read(long realNs, long count) {
    if (sinceNs == Long.MIN_VALUE || count < sinceCount) {
      sinceNs = realNs;
      sinceCount = count;
    } else if (realNs - sinceNs >= SPAN_NS) {
      rate = (count - sinceCount) / Time.seconds(realNs - sinceNs);
      sinceNs = realNs;
      sinceCount = count;
    }
  }

  double perSecond() {
    return rate;
  }
}
