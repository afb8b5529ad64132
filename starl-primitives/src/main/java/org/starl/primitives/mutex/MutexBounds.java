package org.starl.primitives.mutex;

/**
 * The times of the paper's section 4.5, in ns.
 *
 * @param d1Ns the time within which every holder releases after its access
 * @param d2Ns the time within which every request has access, if holders meet d1
 * @param d3Ns the time within which a request without competing requests has access
 */
public record MutexBounds(long d1Ns, long d2Ns, long d3Ns) {

  public MutexBounds {
    if (d1Ns < 0 || d3Ns < 0 || d2Ns < d3Ns) {
      throw new IllegalArgumentException(
          String.format(
              "mutex bounds %s, %s, %s ns: expected d1 >= 0 and 0 <= d3 <= d2", d1Ns, d2Ns, d3Ns));
    }
  }

  /**
   * The algorithm's bounds: {@code d2 = delta + (n - 1)(d1 + 2 delta) + 2 delta}, {@code d3 = 2 delta}. In the first
   * delta of a request's time others may be made that go before it, by their Lamport times: {@code Mutex_progress},
   * with h = delta.
   *
   * @param participants n, the largest number of participants at a time, above 0
   * @param deltaNs delta, the time within which a repeated message arrives
   */
  public static MutexBounds of(int participants, long d1Ns, long deltaNs) {
    if (participants <= 0 || deltaNs < 0) {
      throw new IllegalArgumentException(
          "mutex bounds of " + participants + " participants, delta " + deltaNs + " ns");
    }
    long d3Ns = 2 * deltaNs;
    long d2Ns = Math.addExact(Math.multiplyExact(participants - 1, d1Ns + d3Ns), deltaNs + d3Ns);
    return new MutexBounds(d1Ns, d2Ns, d3Ns);
  }
}
