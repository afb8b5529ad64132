package org.starl.primitives.mutex;

/**
 * The times of the paper's section 4.5, in ns.
 *
 * @param d1Ns every holder releases within this time after its access
 * @param d2Ns then every request has access within this time
 * @param d3Ns a request that nobody stands before has access within this time
 */
public record MutexBounds(long d1Ns, long d2Ns, long d3Ns) {

  public MutexBounds {
    if (d1Ns < 0 || d3Ns < 0 || d2Ns < d3Ns) {
      throw new IllegalArgumentException(
          "mutex bounds " + d1Ns + ", " + d2Ns + ", " + d3Ns + " ns: expected d1, 0 <= d3 <= d2");
    }
  }

  /**
   * What the algorithm gives: {@code d2 = (n - 1)(d1 + 2 delta) + 2 delta}, {@code d3 = 2 delta}.
   *
   * @param participants n, above 0: how many there are at most at a time
   * @param deltaNs a message that is repeated until answered arrives within this time
   */
  public static MutexBounds of(int participants, long d1Ns, long deltaNs) {
    if (participants <= 0 || deltaNs < 0) {
      throw new IllegalArgumentException(
          "mutex bounds of " + participants + " participants, delta " + deltaNs + " ns");
    }
    long d3Ns = 2 * deltaNs;
    long d2Ns = Math.addExact(Math.multiplyExact(participants - 1, d1Ns + d3Ns), d3Ns);
    return new MutexBounds(d1Ns, d2Ns, d3Ns);
  }
}
