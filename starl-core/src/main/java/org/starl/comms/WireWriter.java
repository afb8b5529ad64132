package org.starl.comms;

import java.nio.charset.StandardCharsets;
import org.starl.ProcessId;
import org.starl.RobotId;

/**
 * Writes a message's fields into a buffer of fixed size, big-endian. A message that does not fit is
 * the sender's bug: {@link IllegalArgumentException}.
 */
public final class WireWriter {

  private final byte[] buffer;
  private int length;

  public WireWriter(byte[] buffer) {
    this.buffer = buffer;
  }

  /** Begins anew at {@code position}. */
  void reset(int position) {
    length = position;
  }

  /** Bytes written so far. */
  public int length() {
    return length;
  }

  public void u8(int value) {
    check(value >= 0 && value <= 0xFF, "u8", value);
    room(1);
    buffer[length++] = (byte) value;
  }

  public void bool(boolean value) {
    u8(value ? 1 : 0);
  }

  public void u16(int value) {
    check(value >= 0 && value <= 0xFFFF, "u16", value);
    room(2);
    buffer[length++] = (byte) (value >>> 8);
    buffer[length++] = (byte) value;
  }

  public void i32(int value) {
    room(4);
    for (int shift = 24; shift >= 0; shift -= 8) {
      buffer[length++] = (byte) (value >>> shift);
    }
  }

  public void i64(long value) {
    room(8);
    for (int shift = 56; shift >= 0; shift -= 8) {
      buffer[length++] = (byte) (value >>> shift);
    }
  }

  public void f64(double value) {
    i64(Double.doubleToLongBits(value));
  }

  /** A string of at most 255 bytes in UTF-8, its length first. */
  public void string(String value) {
    byte[] bytes = value.getBytes(StandardCharsets.UTF_8);
    check(bytes.length <= 0xFF, "string length", bytes.length);
    u8(bytes.length);
    raw(bytes);
  }

  /** At most 65,535 bytes, their number first. */
  public void bytes(byte[] value) {
    u16(value.length);
    raw(value);
  }

  public void robot(RobotId id) {
    string(id.name());
  }

  public void process(ProcessId id) {
    robot(id.robot());
    i64(id.inc());
  }

  private void raw(byte[] bytes) {
    room(bytes.length);
    System.arraycopy(bytes, 0, buffer, length, bytes.length);
    length += bytes.length;
  }

  private void room(int bytes) {
    if (length + bytes > buffer.length) {
      throw new IllegalArgumentException(
          "message longer than the " + buffer.length + " bytes of a datagram");
    }
  }

  private static void check(boolean fits, String what, int value) {
    if (!fits) {
      throw new IllegalArgumentException(what + " cannot be " + value);
    }
  }
}
