package org.starl.sim.net;

import org.starl.id.RobotId;

/** Receives every datagram of the network when it is sent, whatever its recipient. */
@FunctionalInterface
public interface NetworkTap {

  /** {@code buffer[0..length)} is valid during this call only. */
  void sent(RobotId from, byte[] buffer, int length);

  /** Stops listening; call once. */
  @FunctionalInterface
  interface Handle {
    void remove();
  }
}
