package org.starl.platform;

import org.starl.id.RobotId;

/**
 * Sends and receives datagrams, best effort: a datagram may be lost, delayed, duplicated,
 * reordered, or arrive after its sender crashed. No order or delivery is guaranteed.
 */
public interface Radio {

  /** Maximum length of a datagram in bytes, authentication included: it fits one Ethernet frame. */
  int MAX_BYTES = 1428;

  /**
   * Sends the first {@code length} bytes of {@code buffer} to one robot. The caller may reuse the
   * buffer when this returns. A datagram to a robot that does not exist is lost.
   */
  void send(RobotId to, byte[] buffer, int length);

  /** Sends to every robot in range except this one. */
  void broadcast(byte[] buffer, int length);

  /** @throws IllegalArgumentException unless the buffer and a datagram have so many bytes */
  static void checkLength(byte[] buffer, int length) {
    if (length < 0 || length > MAX_BYTES || length > buffer.length) {
      throw new IllegalArgumentException(
          "datagram of " + length + " bytes: expected 0 to " + Math.min(MAX_BYTES, buffer.length));
    }
  }

  /** Sets the one receiver of datagrams; datagrams before this call are lost. Call it once. */
  void onReceive(Receiver receiver);

  /** Receives a datagram, on the strand. */
  @FunctionalInterface
  interface Receiver {
    /** {@code buffer[0..length)} is valid during this call only. */
    void received(byte[] buffer, int length);
  }
}
