package org.starl.apps.race.logic;

import java.util.Comparator;
import org.starl.id.RobotId;

/**
 * A robot claims to have won a point. Of several claims on one point the least one counts, on every
 * robot.
 *
 * @param point the point's number in the race, from 0
 * @param atNs when the winner arrived, by its own clock
 * @param keptOffMm 0 if the winner was at the point; else how far from it something kept the winner
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
      String values = point + " at " + atNs + " ns, " + keptOffMm + " mm off";
      throw new IllegalArgumentException("claim on point " + values + ": expected >= 0");
    }
  }

  /** Whether something on the point kept the winner from it. */
  public boolean wasKeptOff() {
    return keptOffMm > 0;
  }

  @Override
  public int compareTo(Claim other) {
    return ORDER.compare(this, other);
  }
}
