package org.starl.comms;

import org.starl.platform.Platform;

/** {@code gvh.comms}: this robot's messages. Strand only. */
public final class Comms {

  private final LamportClock lamportClock = new LamportClock();

  public Comms(Platform platform, int boot) {}

  /** The robot's logical clock; every datagram carries and witnesses it. */
  public LamportClock lamportClock() {
    return lamportClock;
  }

  /**
   * Opens this robot's end of a channel; messages that come before are not acknowledged.
   *
   * @throws IllegalStateException if it is open already
   */
  public <T> Endpoint<T> open(Channel<T> channel, Endpoint.Handler<T> handler) {
    throw new UnsupportedOperationException();
  }
}
