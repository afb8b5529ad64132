package org.starl.apps.race.spec;

/**
 * The times within which progress is owed, in ns. The one for points is generous: it tells a race that
 * stands still from one that is slow.
 *
 * @param toldNs from the first robot that knows a point's winner to the last
 * @param takenNs from one point to the next, whoever is in whose way
 */
public record RaceBounds(long toldNs, long takenNs) {

  private static final double NS_PER_S = 1e9;
  private static final double SLOWEST_MM_PER_S = 25;
  private static final double TURNS_S = 120;

  /** A broadcast is so many copies in 5 s; the next one begins so long after it began. */
  private static final int COPIES = 9;

  private static final double ROUND_S = 8.5;
  private static final double SETTLE_S = 1;

  /** So many copies in a row are not lost in all campaigns together. */
  private static final double NEVER = 1e-13;

  private static final int MOST_COPIES = 50_000;

  public RaceBounds {
    if (toldNs < 0 || takenNs < 0) {
      throw new IllegalArgumentException("bounds " + toldNs + " ns, " + takenNs + " ns");
    }
  }

  /**
   * Bounds of a race.
   *
   * @param longestDelayNs no message that arrives takes longer
   * @param loss probability that a message is lost
   * @param farthestMm no robot is farther from the next point
   */
  public static RaceBounds of(long longestDelayNs, double loss, double farthestMm) {
    int copies = 1;
    for (double all = loss; all > NEVER && copies < MOST_COPIES; all *= loss) {
      copies++;
    }
    int rounds = 1 + (copies + COPIES - 1) / COPIES;
    long toldNs = 2 * longestDelayNs + (long) ((rounds * ROUND_S + SETTLE_S) * NS_PER_S);
    long driveNs = (long) ((farthestMm / SLOWEST_MM_PER_S + TURNS_S) * NS_PER_S);
    return new RaceBounds(toldNs, driveNs + toldNs);
  }
}
