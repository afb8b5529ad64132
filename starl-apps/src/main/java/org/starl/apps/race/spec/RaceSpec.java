package org.starl.apps.race.spec;

import java.util.List;
import java.util.function.Supplier;
import org.starl.apps.race.logic.RacePoint;
import org.starl.spec.Monitor;
import org.starl.time.Time;

/** The monitors of a race itself, and the bounds within which it owes progress. */
public final class RaceSpec {

  /** Generous, to tell a race that stands still from one that is slow. */
  private static final double SLOWEST_MM_PER_S = 25;

  private static final double TURNS_S = 120;

  /**
   * A broadcast sends so many copies in 5 s; the next one begins at most a round after it began.
   */
  private static final int COPIES = 9;

  private static final double ROUND_S = 8.5;
  private static final double SETTLE_S = 1;

  /** So many copies in a row are lost in no run of all campaigns together. */
  private static final double NEVER = 1e-13;

  private static final int MAX_COPIES = 50_000;

  private RaceSpec() {}

  /**
   * Suppliers of monitors: each run needs its own.
   *
   * @param longestDelayNs no message that arrives takes longer
   * @param loss probability that a message is lost
   * @param farthestMm no robot is farther from the next point
   */
  public static List<Supplier<? extends Monitor>> of(
      List<RacePoint> points, long longestDelayNs, double loss, double farthestMm) {
    int copies = 1;
    for (double all = loss; all > NEVER && copies < MAX_COPIES; all *= loss) {
      copies++;
    }
    int rounds = 1 + (copies + COPIES - 1) / COPIES;
    long toldNs = 2 * longestDelayNs + (long) ((rounds * ROUND_S + SETTLE_S) * Time.NS_PER_S);
    long driveNs = (long) ((farthestMm / SLOWEST_MM_PER_S + TURNS_S) * Time.NS_PER_S);
    return List.of(
        () -> new RaceSafety(points), () -> new RaceProgress(points, toldNs, driveNs + toldNs));
  }
}
