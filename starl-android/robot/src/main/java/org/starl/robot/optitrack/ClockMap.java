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
 * <p>Without answers the lower end is an assumption: the fastest datagram in each {@link #WINDOW_NS} took
 * at most {@code maxDelayNs}. The fastest one so far is not enough: after some drift a slower one seems
 * to be as fast. Then a sender's clock that has jumped counts as a new clock, which is used after it has
 * run for {@link #SETTLE_NS} and the old one has not: single false times change nothing.
 *
 * <p>An answer that contradicts the estimate is ignored, unless {@link #CONTRADICTIONS} come in a row: then
 * the clock was set anew. After so many within {@link #DOUBT_NS} of each other no time is certain: some answers are false, or
 * the clock runs at another rate than it is said to.
 *
 * <p>Pure; one thread at a time.
 */
final class ClockMap {

  /** Largest drift of two quartz clocks, in ns per ms: 200 parts per million. */
  static final long DRIFT_NS_PER_MS = 200;

  static final long SETTLE_NS = 500 * NS_PER_MS;

  /** Longer than cameras send slow datagrams alone; in this time clocks drift by 1 ms at most. */
  static final long WINDOW_NS = 5000 * NS_PER_MS;

  /** Datagrams overtake each other by less than this time. */
  static final long JUMP_NS = 1000 * NS_PER_MS;

  /** Contradicting answers that count. */
  static final int CONTRADICTIONS = 3;

  static final long DOUBT_NS = 5000 * NS_PER_MS;

  private final long maxDelayNs;
  private boolean isKnown;
  private boolean hasAnswer;
  private long leastNs;
  private long mostNs;
  private long atNs;
  private long sinceNs;
  private long newestSenderNs;

  // Without answers: what the fastest datagram since windowNs, and the one of the window before,
  // show of the offset at least, plus its delay.
  private long windowNs;
  private long fastestNs;
  private long fastestBeforeNs;

  // Another clock, without answers: since when it runs, and its largest possible offset.
  private boolean hasRival;
  private long rivalSinceNs;
  private long rivalMostNs;

  // Contradicting answers: in a row, and in all.
  private int inARow;
  private int contradictions;
  private long contradictedNs;

  ClockMap(long maxDelayNs) {
    this.maxDelayNs = maxDelayNs;
  }

  /** Uses a datagram, sent at {@code senderNs} by the sender's clock, received by ours. */
  void received(long senderNs, long receivedNs) {
    long mostOffNs = receivedNs - senderNs;
    if (!isKnown) {
      begin(mostOffNs - maxDelayNs, mostOffNs, receivedNs);
      newestSenderNs = senderNs;
      return;
    }
    advanceTo(receivedNs);
    if (hasAnswer && mostOffNs < leastNs) {
      // The datagram's time is in the future. If the sender's clock is wrong, the next answers show
      // it.
      return;
    }
    boolean isBack = newestSenderNs - senderNs > (hasRival ? 0 : JUMP_NS);
    if (!hasAnswer && (mostOffNs < leastNs || isBack)) {
      rival(senderNs, mostOffNs, receivedNs);
      return;
    }
    hasRival = false;
    newestSenderNs = Math.max(newestSenderNs, senderNs);
    mostNs = Math.min(mostNs, mostOffNs);
    if (!hasAnswer) {
      if (receivedNs - windowNs >= WINDOW_NS) {
        windowNs = receivedNs;
        fastestBeforeNs = fastestNs;
        fastestNs = mostOffNs;
      }
      fastestNs = Math.min(fastestNs, mostOffNs);
      leastNs = Math.min(mostNs, Math.min(fastestNs, fastestBeforeNs)) - maxDelayNs;
    }
  }

  private void rival(long senderNs, long mostOffNs, long receivedNs) {
    rivalSinceNs = hasRival ? rivalSinceNs : receivedNs;
    rivalMostNs = hasRival ? Math.min(rivalMostNs, mostOffNs) : mostOffNs;
    hasRival = true;
    if (receivedNs - rivalSinceNs >= SETTLE_NS) {
      begin(rivalMostNs - maxDelayNs, rivalMostNs, rivalSinceNs);
      newestSenderNs = senderNs;
    }
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
    boolean isContradiction = hasAnswer && leastOffNs > mostOffNs;
    count(isContradiction, receivedNs);
    if (isContradiction && inARow < CONTRADICTIONS) {
      return;
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

  private void count(boolean isContradiction, long nowNs) {
    inARow = isContradiction ? inARow + 1 : 0;
    contradictions = nowNs - contradictedNs < DOUBT_NS ? contradictions : 0;
    contradictions += isContradiction ? 1 : 0;
    contradictedNs = isContradiction ? nowNs : contradictedNs;
  }

  /** Whether some answers are false. */
  boolean isContradicted(long nowNs) {
    return contradictions >= CONTRADICTIONS && nowNs - contradictedNs < DOUBT_NS;
  }

  /** Whether {@link #span} is reliable. */
  boolean isSettled(long nowNs) {
    return isKnown && !isContradicted(nowNs) && (hasAnswer || nowNs - sinceNs >= SETTLE_NS);
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
    hasRival = false;
    leastNs = newLeastNs;
    mostNs = newMostNs;
    atNs = nowNs;
    sinceNs = nowNs;
    windowNs = nowNs;
    fastestNs = newMostNs;
    fastestBeforeNs = newMostNs;
  }

  private void advanceTo(long nowNs) {
    long driftNs = driftNs(nowNs - atNs);
    if (driftNs > 0) {
      leastNs -= driftNs;
      mostNs += driftNs;
      fastestNs -= driftNs;
      fastestBeforeNs -= driftNs;
      atNs = nowNs;
    }
  }

  private static long driftNs(long forNs) {
    return forNs * DRIFT_NS_PER_MS / NS_PER_MS;
  }
}
