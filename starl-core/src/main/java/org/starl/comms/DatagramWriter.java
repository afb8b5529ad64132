package org.starl.comms;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;

/**
 * Writes this robot's datagrams (docs/wire-format.md), one after another into a buffer that it may
 * share.
 */
final class DatagramWriter {

  private final int boot;
  private final byte[] sender;
  private final WireWriter out;

  DatagramWriter(RobotId self, int boot, WireWriter out) {
    this.boot = boot;
    this.sender = self.name().getBytes(StandardCharsets.US_ASCII);
    this.out = out;
  }

  /** The robot's own name on the wire. */
  byte[] senderName() {
    return sender;
  }

  /** The datagram last written; valid until the next one. */
  byte[] buffer() {
    return out.buffer();
  }

  /**
   * Writes a plain message ({@code order} 0) or a reliable one.
   *
   * @param to null for everyone
   * @return the datagram's length
   */
  <T> int message(
      OpenEndpoint<T> from, @Nullable RobotId to, T message, long number, long order, long clock) {
    start(order == 0 ? Header.PLAIN : Header.RELIABLE, number, clock, to);
    out.u8(from.name.length);
    out.raw(from.name);
    if (order > 0) {
      out.i64(order);
    }
    int payloadAt = out.length();
    from.channel.codec().write(message, out);
    int length = out.length();
    if (length > Header.MAX_BYTES) {
      out.shrink();
      throw new IllegalArgumentException(
          "channel "
              + from.channel.name()
              + ": a message of "
              + (length - payloadAt)
              + " bytes, at most "
              + (Header.MAX_BYTES - payloadAt)
              + " fit a datagram");
    }
    return finish();
  }

  /** Acknowledges message {@code order} of the incarnation {@code ackedBoot} of {@code to}. */
  int acknowledgement(RobotId to, int ackedBoot, long order, long number, long clock) {
    start(Header.ACK, number, clock, to);
    out.u8(0);
    out.i32(ackedBoot);
    out.i64(order);
    return finish();
  }

  /** Gives a datagram that is transmitted again the clock of now. */
  static void setClock(byte[] datagram, long clock) {
    WireWriter.putI64(datagram, Header.CLOCK_AT, clock);
  }

  private void start(int kind, long number, long clock, @Nullable RobotId to) {
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

  private int finish() {
    int length = out.length();
    out.buffer()[Header.LENGTH_AT] = (byte) (length >>> 8);
    out.buffer()[Header.LENGTH_AT + 1] = (byte) length;
    return length;
  }
}
