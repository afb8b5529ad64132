package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;

/**
 * An interval that certainly contains the difference between our clock and another one: a
 * set-membership estimate. A datagram sent at s by their clock and received at r by ours proves that
 * the difference is at most r - s, because nothing arrives before it is sent. An answer to a question
 * sent at q by our clock also proves that it is at least q - s (Cristian, "Probabilistic clock
 * synchronization", 1989). The intervals are intersected; between datagrams the interval grows by the
 * largest drift of two clocks.
 *
 * <p>Without answers the lower end is an assumption: that the fastest datagram so far took at most
 * {@code maxDelayNs}. Then a clock that jumps back counts as a new one, which is not used until it
 * has run for {@link #SETTLE_NS}.
 *
 * <p>Pure; one thread at a time.
 */
final class ClockMap {

  /** Two quartz clocks stay within this of each other, in ns a ms: 200 parts in a million. */
  static final long DRIFT_NS_PER_MS = 200;

  static final long SETTLE_NS = 500 * NS_PER_MS;

  /** Datagrams overtake each other by less than this. */
  static final long JUMP_NS = 1000 * NS_PER_MS;

  private final long maxDelayNs;
  private boolean isKnown;
  private boolean hasAnswer;
  private long leastNs;
  private long mostNs;
  private long atNs;
  private long sinceNs;
  private long newestTheirNs;

  ClockMap(long maxDelayNs) {
    this.maxDelayNs = maxDelayNs;
  }

  /** A datagram was sent at {@code theirNs} by their clock and received at {@code receivedNs} by ours. */
  void came(long theirNs, long receivedNs) {
    long mostOffNs = receivedNs - theirNs;
    if (!isKnown || (!hasAnswer && newestTheirNs - theirNs > JUMP_NS)) {
      begin(mostOffNs - maxDelayNs, mostOffNs, receivedNs);
      newestTheirNs = theirNs;
      return;
    }
    newestTheirNs = Math.max(newestTheirNs, theirNs);
    advanceTo(receivedNs);
    if (hasAnswer && mostOffNs < leastNs) {
      // From the future: its time is wrong, or their clock is, which the next answer shows.
      return;
    }
    mostNs = Math.min(mostNs, mostOffNs);
    leastNs = hasAnswer ? leastNs : mostNs - maxDelayNs;
  }

  /** Their clock showed {@code theirNs} when they received our question of {@code sentNs}. */
  void answered(long sentNs, long theirNs, long receivedNs) {
    // Their clock showed at least that when the question arrived; only the answer may have been
    // slow.
    long leastSaidNs = sentNs - theirNs - driftNs(receivedNs - sentNs);
    long mostSaidNs = receivedNs - theirNs;
    long leastOffNs = leastSaidNs;
    long mostOffNs = mostSaidNs;
    if (isKnown) {
      advanceTo(receivedNs);
      leastOffNs = hasAnswer ? Math.max(leastOffNs, leastNs) : leastOffNs;
      mostOffNs = Math.min(mostOffNs, mostNs);
    }
    if (!isKnown || leastOffNs > mostOffNs) {
      begin(leastSaidNs, mostSaidNs, receivedNs);
    } else {
      leastNs = leastOffNs;
      mostNs = mostOffNs;
    }
    newestTheirNs = Math.max(newestTheirNs, theirNs);
    hasAnswer = true;
  }

  /** Whether {@link #span} is reliable. */
  boolean isSettled(long nowNs) {
    return isKnown && (hasAnswer || nowNs - sinceNs >= SETTLE_NS);
  }

  /**
   * The interval by our clock of a time from {@code fromTheirNs} to {@code toTheirNs} by theirs that is
   * past at {@code nowNs}. It is empty (ends before it begins) if their time is in the future.
   */
  TimeSpan span(long fromTheirNs, long toTheirNs, long nowNs) {
    advanceTo(nowNs);
    // The interval is of now; at that time the difference may have been larger or smaller by the
    // drift.
    long sinceThenNs = driftNs(Math.max(0, nowNs - fromTheirNs - leastNs));
    return new TimeSpan(
        fromTheirNs + leastNs - sinceThenNs, Math.min(nowNs, toTheirNs + mostNs + sinceThenNs));
  }

  private void begin(long newLeastNs, long newMostNs, long nowNs) {
    isKnown = true;
    hasAnswer = false;
    leastNs = newLeastNs;
    mostNs = newMostNs;
    atNs = nowNs;
    sinceNs = nowNs;
  }

  private void advanceTo(long nowNs) {
    long driftNs = driftNs(nowNs - atNs);
    if (driftNs > 0) {
      leastNs -= driftNs;
      mostNs += driftNs;
      atNs = nowNs;
    }
  }

  private static long driftNs(long forNs) {
    return forNs * DRIFT_NS_PER_MS / NS_PER_MS;
  }
}
