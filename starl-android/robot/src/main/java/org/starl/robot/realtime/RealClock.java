package org.starl.robot.realtime;

import static org.starl.time.Time.NS_PER_S;

import java.time.Instant;
import org.starl.platform.Clock;

/** Real time since its origin; a change of the device's date does not affect it. */
public final class RealClock implements Clock {

  /** The origin of {@link #ofDate}, 2020-01-01T00:00:00Z, in ns since 1970. */
  public static final long DATE_ORIGIN_UNIX_NS = 1_577_836_800 * NS_PER_S;

  private final long originNs;

  /** Its origin is now. */
  public RealClock() {
    this(machineNs());
  }

  /**
   * A clock that agrees with any other of this origin on this machine, also in another process, if the
   * JVM takes {@link System#nanoTime} from the machine's one monotonic clock, as on Linux, macOS and
   * Windows. Callers that depend on that must check it.
   *
   * @param originNs the value of {@link #machineNs} when this clock shows 0
   */
  public RealClock(long originNs) {
    this.originNs = originNs;
  }

  /**
   * A clock whose origin is the beginning of 2020 by the machine's present date; from now on it is
   * monotonic. It continues over restarts of a robot, and robots whose machines agree on the date
   * agree on it.
   */
  public static RealClock ofDate() {
    Instant now = Instant.now();
    long sinceOriginNs =
        Math.addExact(
            Math.multiplyExact(now.getEpochSecond(), NS_PER_S) - DATE_ORIGIN_UNIX_NS,
            now.getNano());
    return new RealClock(machineNs() - sinceOriginNs);
  }

  /** The machine's monotonic clock now, in ns from an arbitrary origin. */
  public static long machineNs() {
    return System.nanoTime();
  }

  /** The value of {@link #machineNs} when this clock shows 0. */
  public long originNs() {
    return originNs;
  }

  @Override
  public long nowNs() {
    return machineNs() - originNs;
  }
}
