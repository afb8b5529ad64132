package org.starl.platform;

import org.starl.id.RobotId;

/**
 * Sends and receives datagrams, best effort: one may be lost, late, doubled, overtaken, or arrive
 * after its sender died. Nothing about order or delivery is promised.
 */
public interface Radio {

  /** No datagram is longer, in bytes, seal included: what fits one Ethernet frame. */
  int MAX_BYTES = 1424;

  /**
   * Sends the first {@code length} bytes of {@code buffer} to one robot. The buffer is the caller's
   * again when this returns. A robot that does not exist is a lost datagram.
   */
  void send(RobotId to, byte[] buffer, int length);

  /** Sends to every robot in reach except this one. */
  void broadcast(byte[] buffer, int length);

  /** Sets the one receiver of what arrives; before that, datagrams are lost. Called once. */
  void onReceive(Receiver receiver);

  /** Takes a datagram, on the strand. */
  @FunctionalInterface
  interface Receiver {
    /** {@code buffer[0..length)} is valid during this call only. */
    void received(byte[] buffer, int length);
  }
}
