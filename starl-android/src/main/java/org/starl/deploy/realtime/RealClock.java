package org.starl.deploy.realtime;

import org.starl.platform.Clock;

/** Real time since its origin; setting the device's date does not touch it. */
public final class RealClock implements Clock {

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

  /** The machine's monotonic clock now, in ns from a time that means nothing. */
  public static long machineNs() {
    return System.nanoTime();
  }

  @Override
  public long nowNs() {
    return machineNs() - originNs;
  }
}
