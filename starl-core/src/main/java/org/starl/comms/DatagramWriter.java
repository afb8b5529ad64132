package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.shape.WireWriter;

/**
 * Writes datagrams (docs/wire-format.md) into one reused buffer: call {@link #begin}, then one
 * other method.
 */
final class DatagramWriter {

  private final WireWriter out = new WireWriter();

  /** The last datagram; valid until the next {@link #begin}. */
  byte[] buffer() {
    return out.buffer();
  }

  /**
   * Begins a datagram.
   *
   * @param kind one of {@link Header}'s kinds
   * @param sender the sender's name in ASCII
   * @param to null for a broadcast
   */
  void begin(int kind, byte[] sender, int boot, long number, long clock, @Nullable RobotId to) {
    out.reset(0);
    out.u8(Header.MAGIC_0);
    out.u8(Header.MAGIC_1);
    out.u8(Header.VERSION);
    out.u8(kind);
    out.u16(0);
    out.i32(boot);
    out.i64(number);
    out.i64(clock);
    out.u8(sender.length);
    out.raw(sender);
    if (to == null) {
      out.u8(0);
    } else {
      out.robot(to);
    }
  }

  /**
   * Completes a plain message ({@code order} 0) or a reliable one.
   *
   * @return the datagram's length in bytes
   */
  <T> int message(OpenEndpoint<T> from, T message, long order) {
    out.u8(from.name.length);
    out.raw(from.name);
    if (order > 0) {
      out.i64(order);
    }
    int payloadAt = out.length();
    from.channel.shape().write(message, out);
    int length = out.length();
    if (length > Header.MAX_BYTES) {
      out.shrink();
      throw new IllegalArgumentException(
          String.format(
              "channel %s: a message of %s bytes, at most %s fit a datagram",
              from.channel.name(), length - payloadAt, Header.MAX_BYTES - payloadAt));
    }
    return end();
  }

  /**
   * Completes an acknowledgement of message {@code order} of the addressee's incarnation {@code
   * ackedBoot}.
   *
   * @return the datagram's length in bytes
   */
  int acknowledgement(int ackedBoot, long order) {
    out.u8(0);
    out.i32(ackedBoot);
    out.i64(order);
    return end();
  }

  /** Updates the Lamport clock in a datagram that is transmitted again. */
  static void setClock(byte[] datagram, long clock) {
    WireWriter.putI64(datagram, Header.CLOCK_AT, clock);
  }

  private int end() {
    int length = out.length();
    out.buffer()[Header.LENGTH_AT] = (byte) (length >>> 8);
    out.buffer()[Header.LENGTH_AT + 1] = (byte) length;
    return length;
  }
}
