package org.starl.sim.explore;

import org.starl.time.Time;

/**
 * What a schedule may change. The run before {@code fromNs} is as its seed draws it.
 *
 * @param fromNs the first instant at which a copy that is sent may be changed, in ns of virtual
 *     time
 * @param leastDelayNs shortest delay of a copy
 * @param mostDelayNs longest delay of a copy, not below the shortest
 * @param mostExtraNs largest additional delay of a link: the longest delay, less the longest one
 *     that the network itself draws
 * @param losses the largest number of lost copies
 * @param crashes the largest number of crashes
 * @param downNs time from a crash to the restart, above 0
 */
public record Bounds(
    long fromNs,
    long leastDelayNs,
    long mostDelayNs,
    long mostExtraNs,
    int losses,
    int crashes,
    long downNs) {

  // As much as chaos adds at most.
  private static final long LEAST_DELAY_NS = Time.NS_PER_MS;
  private static final long MOST_DELAY_NS = 800 * Time.NS_PER_MS;

  public Bounds {
    if (fromNs < 0 || leastDelayNs < 0 || mostDelayNs < leastDelayNs) {
      throw new IllegalArgumentException(
          "from %d ns, delays from %d to %d ns: expected at least 0, the smaller delay first"
              .formatted(fromNs, leastDelayNs, mostDelayNs));
    }
    if (mostExtraNs < 0 || mostExtraNs > mostDelayNs) {
      throw new IllegalArgumentException(
          mostExtraNs + " ns more: expected from 0 to " + mostDelayNs + " ns");
    }
    if (losses < 0 || crashes < 0 || downNs <= 0) {
      throw new IllegalArgumentException(
          "%d losses, %d crashes of %d ns: expected at least 0, and a time above 0"
              .formatted(losses, crashes, downNs));
    }
  }

  /**
   * Other delays, of 1 ms to 800 ms, without losses and crashes.
   *
   * @param drawnNs the longest delay that the network itself draws
   */
  public static Bounds ofDelays(long fromNs, long drawnNs) {
    long extraNs = Math.max(0, MOST_DELAY_NS - drawnNs);
    return new Bounds(fromNs, LEAST_DELAY_NS, MOST_DELAY_NS, extraNs, 0, 0, 1);
  }
}
