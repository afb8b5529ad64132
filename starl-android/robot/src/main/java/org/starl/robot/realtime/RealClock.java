package org.starl.robot.realtime;

import java.time.Instant;
import org.starl.platform.Clock;

/** Real time since its origin; setting the device's date does not touch it. */
public final class RealClock implements Clock {

  // 2020-01-01T00:00:00Z
  private static final long ORIGIN_UNIX_S = 1_577_836_800;
  private static final long NS_PER_S = 1_000_000_000;

  private final long originNs;

  /** Its origin is now. */
  public RealClock() {
    this(machineNs());
  }

  /**
   * A clock that shows the same as any other of this origin on this machine, in another process too:
   * where the JVM takes {@link System#nanoTime} from the machine's one monotonic clock, as on Linux,
   * macOS and Windows. Who depends on that checks it.
   *
   * @param originNs what {@link #machineNs} said when this clock showed 0
   */
  public RealClock(long originNs) {
    this.originNs = originNs;
  }

  /**
   * A clock whose origin is the beginning of 2020, by what the machine takes for the date now; from
   * here on it is monotonic. A robot that starts again goes on counting, and robots whose machines
   * agree on the date agree on this.
   */
  public static RealClock ofDate() {
    Instant now = Instant.now();
    long sinceOriginNs =
        Math.addExact(
            Math.multiplyExact(now.getEpochSecond() - ORIGIN_UNIX_S, NS_PER_S), now.getNano());
    return new RealClock(machineNs() - sinceOriginNs);
  }

  /** The machine's monotonic clock now, in ns from a time that means nothing. */
  public static long machineNs() {
    return System.nanoTime();
  }

  /** What {@link #machineNs} said when this clock showed 0. */
  public long originNs() {
    return originNs;
  }

  @Override
  public long nowNs() {
    return machineNs() - originNs;
  }
}
