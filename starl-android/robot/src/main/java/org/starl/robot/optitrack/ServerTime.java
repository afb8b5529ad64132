package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import org.jspecify.annotations.Nullable;

/** Converts the time stamps of frames, which are ticks of the server's clock, to our clock. */
final class ServerTime {

  /** The greatest rate for which ticks can be converted to ns. */
  private static final long MAX_TICKS_PER_S = 9 * NS_PER_S;

  private static final long MAX_S = 4_000_000_000L;

  private final FixBounds bounds;
  private ClockMap map;
  private long ticksPerS;

  ServerTime(FixBounds bounds) {
    this.bounds = bounds;
    this.map = new ClockMap(bounds.maxDelayNs());
  }

  /** Starts the estimate for a new clock with this rate, 0 if unknown. */
  void begin(long newTicksPerS) {
    ticksPerS = newTicksPerS > 0 && newTicksPerS <= MAX_TICKS_PER_S ? newTicksPerS : 0;
    map = new ClockMap(bounds.maxDelayNs());
  }

  /** Uses the server's answer to a request sent at {@code sentNs}. */
  void answered(long sentNs, long ticks, long receivedNs) {
    if (isStamp(ticks)) {
      map.answered(sentNs, ns(ticks), receivedNs);
    }
  }

  /** Whether answers contradict each other: some are false, or the rate is. */
  boolean isContradicted(long nowNs) {
    return map.isContradicted(nowNs);
  }

  /**
   * The time span in which the frame was measured; null if it is not known yet. Without usable stamps
   * the assumed largest delay bounds it.
   */
  @Nullable TimeSpan measured(MocapFrame frame, long receivedNs) {
    if (!isStamp(frame.transmittedTicks())) {
      return new TimeSpan(receivedNs - bounds.maxDelayNs() - bounds.maxLatencyNs(), receivedNs);
    }
    long sentNs = ns(frame.transmittedTicks());
    map.received(sentNs, receivedNs);
    if (!map.isSettled(receivedNs)) {
      return null;
    }
    if (isStamp(frame.exposedTicks())) {
      long exposedNs = Math.min(sentNs, ns(frame.exposedTicks()));
      return map.span(exposedNs, exposedNs, receivedNs);
    }
    long knownNs =
        isStamp(frame.collectedTicks()) ? Math.min(sentNs, ns(frame.collectedTicks())) : sentNs;
    return map.span(knownNs - bounds.maxLatencyNs(), knownNs, receivedNs);
  }

  private boolean isStamp(long ticks) {
    return ticksPerS > 0 && ticks > 0 && ticks / ticksPerS <= MAX_S;
  }

  private long ns(long ticks) {
    return ticks / ticksPerS * NS_PER_S + ticks % ticksPerS * NS_PER_S / ticksPerS;
  }
}
