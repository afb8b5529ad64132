package org.starl.sim.explore;

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
}
