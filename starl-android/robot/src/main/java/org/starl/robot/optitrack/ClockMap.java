package org.starl.robot.optitrack;

/**
 * What is known of the difference between our clock and another one, as an interval that holds it
 * for certain: a set-membership estimate. A datagram that left at s of their clock and came at r of
 * ours says that the difference is at most r - s, as nothing arrives before it is sent. An answer to
 * a question of ours that was sent at q says besides that it is at least q - s (Cristian,
 * "Probabilistic clock synchronization", 1989). What several say is intersected; between them the
 * interval grows by what two clocks drift apart.
 *
 * <p>Without answers the lower end is an assumption: that the fastest datagram so far took at most
 * {@code maxDelayNs}. Then a clock that jumps back is taken for a new one, and not believed before
 * it has gone on for {@link #SETTLE_NS}.
 *
 * <p>Pure; one thread at a time.
 */
final class ClockMap {

  /** Two quartz clocks stay within this of each other, in ns a ms: 200 parts in a million. */
  static final long DRIFT_NS_PER_MS = 200;

  static final long SETTLE_NS = 500_000_000;

  /** Datagrams overtake each other by less. */
  static final long JUMP_NS = 1_000_000_000;

  private static final long NS_PER_MS = 1_000_000;

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

  /** A datagram left at {@code theirNs} of their clock and came at {@code receivedNs} of ours. */
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
      // It comes from the future: its time is wrong, or the next answer shows that their clock is.
      return;
    }
    mostNs = Math.min(mostNs, mostOffNs);
    leastNs = hasAnswer ? leastNs : mostNs - maxDelayNs;
  }

  /** They had {@code theirNs} when they got what we sent at {@code sentNs}. */
  void answered(long sentNs, long theirNs, long receivedNs) {
    // It was at least that when they got the question; it may have come quickly, the answer late.
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

  /** Whether {@link #span} can be relied on. */
  boolean isSettled(long nowNs) {
    return isKnown && (hasAnswer || nowNs - sinceNs >= SETTLE_NS);
  }

  /**
   * When, on our clock, it was some time from {@code fromTheirNs} to {@code toTheirNs} on theirs, if
   * that is over at {@code nowNs}. Ends before it begins if they speak of the future.
   */
  TimeSpan span(long fromTheirNs, long toTheirNs, long nowNs) {
    advanceTo(nowNs);
    // The interval is that of now; then, the clocks may have been further apart, or nearer.
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
