package org.starl.sim.fault;

import org.starl.platform.Clock;

/**
 * A robot's own clock, which runs too fast or too slow, ahead or behind, but never backwards: where
 * it has to go back it stands still until its time has come. It outlives the robot's program.
 */
public final class RobotClock implements Clock {

  private static final long MILLION = 1_000_000;

  // Beyond this no time is told apart: 30 years.
  private static final long FAR_NS = 1_000_000_000_000_000_000L;

  private final Clock trueClock;
  private long anchorTrueNs;
  private long anchorLocalNs;
  private long driftPpm;
  private long skewNs;
  private long shownNs;

  public RobotClock(Clock trueClock) {
    this.trueClock = trueClock;
    anchorTrueNs = trueClock.nowNs();
    anchorLocalNs = anchorTrueNs;
  }

  /**
   * From now on it runs so.
   *
   * @param newDriftPpm so many microseconds a second too fast, above -1,000,000
   * @param newSkewNs so much ahead of what it would show without
   */
  void set(long newDriftPpm, long newSkewNs) {
    if (newDriftPpm <= -MILLION) {
      throw new IllegalArgumentException("drift " + newDriftPpm + " ppm: the clock would stand");
    }
    shownNs = nowNs();
    long nowNs = trueClock.nowNs();
    anchorLocalNs = runningNs(nowNs) + newSkewNs - skewNs;
    anchorTrueNs = nowNs;
    driftPpm = newDriftPpm;
    skewNs = newSkewNs;
  }

  @Override
  public long nowNs() {
    return Math.max(shownNs, runningNs(trueClock.nowNs()));
  }

  /** The first true time, not before now, at which it shows {@code localNs}, if it goes on so. */
  long trueNs(long localNs) {
    long nowNs = trueClock.nowNs();
    if (localNs <= nowNs()) {
      return nowNs;
    }
    long aheadNs = localNs - anchorLocalNs;
    if (aheadNs > FAR_NS || aheadNs < 0) {
      return Long.MAX_VALUE;
    }
    long trueNs = anchorTrueNs + (long) (aheadNs * (MILLION / (double) (MILLION + driftPpm)));
    trueNs = Math.max(trueNs, nowNs);
    // Rounding leads a few ns astray, one way or the other.
    while (runningNs(trueNs) < localNs) {
      trueNs++;
    }
    while (trueNs > nowNs && runningNs(trueNs - 1) >= localNs) {
      trueNs--;
    }
    return trueNs;
  }

  private long runningNs(long trueNs) {
    long sinceNs = trueNs - anchorTrueNs;
    long extraNs = sinceNs / MILLION * driftPpm + sinceNs % MILLION * driftPpm / MILLION;
    return anchorLocalNs + sinceNs + extraNs;
  }
}
