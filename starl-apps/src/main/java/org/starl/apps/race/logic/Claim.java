package org.starl.apps.race.logic;

import java.util.Comparator;
import org.starl.id.RobotId;

/**
 * A robot has won a point. Of several claims on one point the least one counts, everywhere.
 *
 * @param point its place in the race, from 0
 * @param atNs when the winner arrived, by its own clock
 * @param keptOffMm 0 if it was at the point; else something stood there, and the winner was so far off
 */
public record Claim(int point, RobotId winner, long atNs, int keptOffMm)
    implements RaceMessage, Comparable<Claim> {

  private static final Comparator<Claim> ORDER =
      Comparator.comparingInt(Claim::point)
          .thenComparing(Claim::wasKeptOff)
          .thenComparingLong(Claim::atNs)
          .thenComparing(Claim::winner)
          .thenComparingInt(Claim::keptOffMm);

  public Claim {
    if (point < 0 || atNs < 0 || keptOffMm < 0) {
      throw new IllegalArgumentException(
          "claim on point "
              + point
              + " at "
              + atNs
              + " ns, "
              + keptOffMm
              + " mm off: expected >= 0");
    }
  }

  /** Whether the winner could not get to the point, because something stands there. */
  public boolean wasKeptOff() {
    return keptOffMm > 0;
  }

  @Override
  public int compareTo(Claim other) {
    return ORDER.compare(this, other);
  }
}
