package org.starl.robot.optitrack;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Reads little-endian values in sequence. Every method throws {@link BufferUnderflowException} if too
 * few bytes remain, or if a size or a count is impossible.
 */
final class LittleEndianReader {

  /** Longest name in NatNet, its final NUL included. */
  static final int MAX_NAME_BYTES = 256;

  private final ByteBuffer in;

  /** Over {@code bytes[from..end)}. */
  LittleEndianReader(byte[] bytes, int from, int end) {
    in = ByteBuffer.wrap(bytes, from, end - from).order(ByteOrder.LITTLE_ENDIAN);
  }

  int remaining() {
    return in.remaining();
  }

  int u8() {
    return in.get() & 0xff;
  }

  int u16() {
    return in.getShort() & 0xffff;
  }

  int i32() {
    return in.getInt();
  }

  long i64() {
    return in.getLong();
  }

  double f32() {
    return in.getFloat();
  }

  /** A UTF-8 string that ends with NUL within {@link #MAX_NAME_BYTES}. */
  String name() {
    int from = in.position();
    skipName();
    return new String(in.array(), from, in.position() - 1 - from, StandardCharsets.UTF_8);
  }

  /** A string in a field of {@code size} bytes. */
  String fixedName(int size) {
    return section(size).name();
  }

  void skipName() {
    int from = in.position();
    while (in.get() != 0) {
      require(in.position() - from < MAX_NAME_BYTES);
    }
  }

  void skipNames(int count) {
    for (int i = 0; i < count; i++) {
      skipName();
    }
  }

  void skip(long count) {
    require(count >= 0 && count <= in.remaining());
    // Through the base class: only newer Java has ByteBuffer.position(int) of its own.
    ((java.nio.Buffer) in).position(in.position() + (int) count);
  }

  /** The number of following elements, of at least {@code minBytes} each. */
  int count(int minBytes) {
    int count = i32();
    require(count >= 0 && (long) count * minBytes <= in.remaining());
    return count;
  }

  /** A reader of the next {@code size} bytes, which this one skips. */
  LittleEndianReader section(int size) {
    int from = in.position();
    skip(size);
    return new LittleEndianReader(in.array(), from, in.position());
  }

  static void require(boolean isPossible) {
    if (!isPossible) {
      throw new BufferUnderflowException();
    }
  }
}
