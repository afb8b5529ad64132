package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;

/**
 * An interval that contains the offset of our clock to a sender's clock: a set-membership estimate. A
 * datagram sent at s by the sender's clock and received at r by ours proves an offset of at most
 * r - s, because no datagram arrives before it is sent. The answer to a request sent at q by our clock
 * also proves an offset of at least q - s (Cristian, "Probabilistic clock synchronization", 1989). The
 * estimate is the intersection of these intervals; between datagrams it grows by the largest drift of
 * two clocks.
 *
 * <p>Without answers the lower end is an assumption: the fastest datagram so far took at most {@code
 * maxDelayNs}. Then a sender's clock that jumps back counts as a new clock, which is used after it has
 * run for {@link #SETTLE_NS}.
 *
 * <p>Pure; one thread at a time.
 */
final class ClockMap {

  /** Largest drift of two quartz clocks, in ns per ms: 200 parts per million. */
  static final long DRIFT_NS_PER_MS = 200;

  static final long SETTLE_NS = 500 * NS_PER_MS;

  /** Datagrams overtake each other by less than this time. */
  static final long JUMP_NS = 1000 * NS_PER_MS;

  private final long maxDelayNs;
  private boolean isKnown;
  private boolean hasAnswer;
  private long leastNs;
  private long mostNs;
  private long atNs;
  private long sinceNs;
  private long newestSenderNs;

  ClockMap(long maxDelayNs) {
    this.maxDelayNs = maxDelayNs;
  }

  /** Uses a datagram, sent at {@code senderNs} by the sender's clock, received by ours. */
  void received(long senderNs, long receivedNs) {
    long mostOffNs = receivedNs - senderNs;
    if (!isKnown || (!hasAnswer && newestSenderNs - senderNs > JUMP_NS)) {
      begin(mostOffNs - maxDelayNs, mostOffNs, receivedNs);
      newestSenderNs = senderNs;
      return;
    }
    newestSenderNs = Math.max(newestSenderNs, senderNs);
    advanceTo(receivedNs);
    if (hasAnswer && mostOffNs < leastNs) {
      // The datagram's time is in the future. If the sender's clock is wrong, the next answer shows
      // it.
      return;
    }
    mostNs = Math.min(mostNs, mostOffNs);
    leastNs = hasAnswer ? leastNs : mostNs - maxDelayNs;
  }

  /** Uses the answer to our request of {@code sentNs}, received at {@code senderNs}. */
  void answered(long sentNs, long senderNs, long receivedNs) {
    // The request arrived before the answer left, so the answer alone may have been slow.
    long leastAnsweredNs = sentNs - senderNs - driftNs(receivedNs - sentNs);
    long mostAnsweredNs = receivedNs - senderNs;
    long leastOffNs = leastAnsweredNs;
    long mostOffNs = mostAnsweredNs;
    if (isKnown) {
      advanceTo(receivedNs);
      leastOffNs = hasAnswer ? Math.max(leastOffNs, leastNs) : leastOffNs;
      mostOffNs = Math.min(mostOffNs, mostNs);
    }
    if (!isKnown || leastOffNs > mostOffNs) {
      begin(leastAnsweredNs, mostAnsweredNs, receivedNs);
    } else {
      leastNs = leastOffNs;
      mostNs = mostOffNs;
    }
    newestSenderNs = Math.max(newestSenderNs, senderNs);
    hasAnswer = true;
  }

  /** Whether {@link #span} is reliable. */
  boolean isSettled(long nowNs) {
    return isKnown && (hasAnswer || nowNs - sinceNs >= SETTLE_NS);
  }

  /**
   * The interval by our clock of a time between {@code fromSenderNs} and {@code toSenderNs} by the
   * sender's clock, cut off at {@code nowNs}. It ends before it begins if that time is in the future.
   */
  TimeSpan span(long fromSenderNs, long toSenderNs, long nowNs) {
    advanceTo(nowNs);
    // The estimate is for now; at that time the offset may have differed by the drift.
    long sinceThenNs = driftNs(Math.max(0, nowNs - fromSenderNs - leastNs));
    return new TimeSpan(
        fromSenderNs + leastNs - sinceThenNs, Math.min(nowNs, toSenderNs + mostNs + sinceThenNs));
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
