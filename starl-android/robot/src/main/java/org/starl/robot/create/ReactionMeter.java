package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Measures the time from a change of the commanded forward speed until odometry shows half of it: the
 * reaction that {@code limits.reactionMs} promises, without the last part of braking. Pure.
 */
public final class ReactionMeter {

  /** Smaller changes are not told from noise. */
  private static final double LEAST_MM_PER_S = 50;

  private static final int MOST = 100_000;

  private final long limitNs;
  private final List<Long> measured = new ArrayList<>();
  private double commandedMmPerS;
  private double fromMmPerS;
  private double toMmPerS;
  private long changedNs = Long.MIN_VALUE;
  private boolean isTold;

  /** @param limitMs what the deployment promises */
  public ReactionMeter(long limitMs) {
    limitNs = limitMs * NS_PER_MS;
  }

  /** A forward speed that is sent. */
  public void sent(double now, long nowNs) {
    if (Math.abs(now - commandedMmPerS) >= LEAST_MM_PER_S) {
      fromMmPerS = commandedMmPerS;
      toMmPerS = now;
      changedNs = nowNs;
    }
    commandedMmPerS = now;
  }

  /** Odometry; a line if the base took longer than promised for the first time. */
  public @Nullable String odometry(double linearMmPerS, long nowNs) {
    if (changedNs == Long.MIN_VALUE) {
      return null;
    }
    boolean isFollowed =
        Math.abs(linearMmPerS - fromMmPerS) >= Math.abs(toMmPerS - fromMmPerS) / 2
            && (linearMmPerS - fromMmPerS) * (toMmPerS - fromMmPerS) > 0;
    long tookNs = nowNs - changedNs;
    if (isFollowed) {
      changedNs = Long.MIN_VALUE;
      if (measured.size() < MOST) {
        measured.add(tookNs);
      }
    }
    if (tookNs <= limitNs || isTold) {
      return null;
    }
    isTold = true;
    return "the base has not followed a command within "
        + limitNs / NS_PER_MS
        + " ms: expected limits.reactionMs to be its reaction time";
  }

  /** A line for people about everything measured so far. */
  public String summary() {
    List<Long> sorted = new ArrayList<>(measured);
    Collections.sort(sorted);
    return sorted.isEmpty()
        ? "no command was followed by odometry"
        : String.format(
            Locale.ROOT,
            "%d commands were followed by odometry after %.0f ms at the median, %.0f ms at 99 %%, %.0f"
                + " ms at most; limits.reactionMs is %d",
            sorted.size(),
            ms(sorted, 0.5),
            ms(sorted, 0.99),
            ms(sorted, 1),
            limitNs / NS_PER_MS);
  }

  private static double ms(List<Long> sorted, double part) {
    return (double) sorted.get((int) (part * (sorted.size() - 1))) / NS_PER_MS;
  }
}
