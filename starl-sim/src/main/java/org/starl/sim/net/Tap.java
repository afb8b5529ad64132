package org.starl.sim.net;

import org.starl.id.RobotId;

/** Somebody who listens to the air: hears every datagram as it is sent, whoever it is for. */
@FunctionalInterface
public interface Tap {

  /** {@code buffer[0..length)} is valid during this call only. */
  void sent(RobotId from, byte[] buffer, int length);

  /** Stops listening; once. */
  @FunctionalInterface
  interface Handle {
    void remove();
  }
}
