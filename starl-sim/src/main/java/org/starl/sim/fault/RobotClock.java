package org.starl.sim.fault;

import org.starl.platform.Clock;

/**
 * A robot's own clock, which may be too fast or too slow, ahead or behind, but never runs
 * backwards: instead it stops until its time is reached. It outlives the robot's program.
 */
public final class RobotClock implements Clock {

  private static final long MILLION = 1_000_000;

  // The maximum time of the clock: 30 years.
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
   * Sets drift and skew from now on.
   *
   * @param newDriftPpm rate by which the clock is too fast, in us per s, above -1,000,000
   * @param newSkewNs time by which the clock is ahead, in ns
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

  /**
   * The first true time, from now on, at which the clock shows {@code localNs} with the current
   * drift and skew.
   */
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
    // Rounding errs by a few ns in either direction.
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
