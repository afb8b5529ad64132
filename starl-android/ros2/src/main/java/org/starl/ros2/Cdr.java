package org.starl.ros2;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * A message in the Common Data Representation (OMG, XCDR1), as ROS 2 sends it: four bytes of
 * encapsulation, then the fields, each aligned to its size. Reading beyond the end throws a {@link
 * java.nio.BufferUnderflowException}.
 */
final class Cdr {

  private static final int HEADER_BYTES = 4;
  private static final byte LITTLE = 1;
  private static final int MOST_BYTES = 60_000;

  private final ByteBuffer buffer;

  private Cdr(ByteBuffer buffer) {
    this.buffer = buffer;
  }

  /** A received message. */
  static Cdr of(byte[] bytes) {
    ByteBuffer buffer = ByteBuffer.wrap(bytes);
    boolean isLittle = bytes.length >= HEADER_BYTES && bytes[1] == LITTLE;
    buffer.order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    buffer.position(Math.min(HEADER_BYTES, bytes.length));
    return new Cdr(buffer);
  }

  /** A message to write. */
  static Cdr empty() {
    ByteBuffer buffer = ByteBuffer.allocate(MOST_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    buffer.put(1, LITTLE).position(HEADER_BYTES);
    return new Cdr(buffer);
  }

  /** What was written. */
  byte[] bytes() {
    byte[] bytes = new byte[buffer.position()];
    buffer.get(0, bytes);
    return bytes;
  }

  int u8() {
    return buffer.get() & 0xFF;
  }

  int i32() {
    return align(4).getInt();
  }

  double f32() {
    return align(4).getFloat();
  }

  double f64() {
    return align(8).getDouble();
  }

  /** A number of elements of at least {@code leastBytes}. */
  int count(int leastBytes) {
    int count = i32();
    if (count < 0 || count > buffer.remaining() / leastBytes) {
      throw new java.nio.BufferUnderflowException();
    }
    return count;
  }

  String text() {
    byte[] bytes = new byte[count(1)];
    buffer.get(bytes);
    return new String(bytes, 0, Math.max(0, bytes.length - 1), StandardCharsets.UTF_8);
  }

  Cdr u8(int value) {
    buffer.put((byte) value);
    return this;
  }

  Cdr i32(int value) {
    align(4).putInt(value);
    return this;
  }

  Cdr f32(double... values) {
    for (double value : values) {
      align(4).putFloat((float) value);
    }
    return this;
  }

  Cdr f64(double... values) {
    for (double value : values) {
      align(8).putDouble(value);
    }
    return this;
  }

  Cdr text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    i32(bytes.length + 1);
    buffer.put(bytes).put((byte) 0);
    return this;
  }

  /** A header: a time since 1970 and a frame. */
  Cdr header(long unixNs, String frame) {
    return i32((int) Math.floorDiv(unixNs, 1_000_000_000L))
        .i32((int) Math.floorMod(unixNs, 1_000_000_000L))
        .text(frame);
  }

  private ByteBuffer align(int bytes) {
    int over = (buffer.position() - HEADER_BYTES) % bytes;
    int skipped = over == 0 ? 0 : bytes - over;
    if (skipped > buffer.remaining()) {
      throw new java.nio.BufferUnderflowException();
    }
    return buffer.position(buffer.position() + skipped);
  }
}
