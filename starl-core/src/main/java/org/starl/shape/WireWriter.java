package org.starl.shape;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.function.Consumer;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * Writes a message's fields, big-endian. A value that the format cannot represent, or a message
 * longer than the buffer, is a bug of the sender: {@link IllegalArgumentException}.
 */
public final class WireWriter {

  private static final int FIRST_SIZE = 96;

  private final boolean grows;
  private byte[] buffer;
  private int length;

  /** Writes into {@code buffer}, which does not grow. */
  public WireWriter(byte[] buffer) {
    this.buffer = buffer;
    this.grows = false;
  }

  /** Writes into its own buffer, which grows. */
  public WireWriter() {
    this.buffer = new byte[FIRST_SIZE];
    this.grows = true;
  }

  /** The bytes that {@code writer} writes. */
  public static byte[] toBytes(Consumer<WireWriter> writer) {
    WireWriter out = new WireWriter();
    writer.accept(out);
    return Arrays.copyOf(out.buffer, out.length);
  }

  /** Continues at {@code position}. */
  public void reset(int position) {
    length = position;
  }

  /** Releases the memory of a message that was too long, and starts again. */
  public void shrink() {
    buffer = new byte[FIRST_SIZE];
    length = 0;
  }

  /** The buffer: its first {@link #length} bytes are written. Valid until the next write. */
  public byte[] buffer() {
    return buffer;
  }

  /** Number of bytes written so far. */
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
    room(Long.BYTES);
    putI64(buffer, length, value);
    length += Long.BYTES;
  }

  /** Writes eight bytes at {@code at} into {@code bytes}, big-endian. */
  public static void putI64(byte[] bytes, int at, long value) {
    for (int i = 0; i < Long.BYTES; i++) {
      bytes[at + i] = (byte) (value >>> (56 - 8 * i));
    }
  }

  /** Writes a double; infinities and NaN are refused. */
  public void f64(double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("f64 cannot be " + value);
    }
    i64(Double.doubleToLongBits(value));
  }

  /** Writes a string of at most 255 bytes in UTF-8, after its length in one byte. */
  public void string(String value) {
    int chars = value.length();
    if (chars > 0xFF) {
      throw new IllegalArgumentException("string length cannot be " + chars);
    }
    room(1 + chars);
    int at = length + 1;
    for (int i = 0; i < chars; i++) {
      char c = value.charAt(i);
      if (c >= 0x80) {
        encoded(value);
        return;
      }
      buffer[at++] = (byte) c;
    }
    buffer[length] = (byte) chars;
    length = at;
  }

  /** Writes a string in UTF-8, without its length: the last field, for {@link WireReader#text}. */
  public void text(String value) {
    ByteBuffer utf8 = utf8(value);
    room(utf8.remaining());
    append(utf8);
  }

  private void encoded(String value) {
    ByteBuffer utf8 = utf8(value);
    int bytes = utf8.remaining();
    check(bytes <= 0xFF, "string length", bytes);
    room(1 + bytes);
    buffer[length++] = (byte) bytes;
    append(utf8);
  }

  private void append(ByteBuffer bytes) {
    int count = bytes.remaining();
    bytes.get(buffer, length, count);
    length += count;
  }

  private static ByteBuffer utf8(String value) {
    try {
      // An encoder reports half a surrogate pair; String.getBytes would write a '?'.
      return StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(value));
    } catch (CharacterCodingException e) {
      throw new IllegalArgumentException("a string with half a surrogate pair", e);
    }
  }

  /** Writes at most 65,535 bytes, after their number in two bytes. */
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

  /** Writes the bytes without their number. */
  public void raw(byte[] bytes) {
    room(bytes.length);
    System.arraycopy(bytes, 0, buffer, length, bytes.length);
    length += bytes.length;
  }

  private void room(int bytes) {
    if (length + bytes > buffer.length) {
      if (!grows) {
        throw new IllegalArgumentException(
            "message longer than the " + buffer.length + " bytes of a datagram");
      }
      buffer = Arrays.copyOf(buffer, Math.max(2 * buffer.length, length + bytes));
    }
  }

  private static void check(boolean fits, String what, int value) {
    if (!fits) {
      throw new IllegalArgumentException(what + " cannot be " + value);
    }
  }
}
