package org.starl.deploy.realtime;

import org.starl.platform.Clock;

/** Real time since this clock was made; setting the device's date does not touch it. */
public final class RealClock implements Clock {

  private final long originNs = System.nanoTime();

  @Override
  public long nowNs() {
    return System.nanoTime() - originNs;
  }
}
