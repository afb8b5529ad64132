package org.starl.robot.optitrack;

import java.nio.BufferOverflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Writes one NatNet datagram, header first. */
final class LittleEndianWriter {

  private final ByteBuffer out =
      ByteBuffer.allocate(Message.MAX_BYTES).order(ByteOrder.LITTLE_ENDIAN);

  /** Begins message number {@code id} and discards earlier content. */
  LittleEndianWriter begin(int id) {
    // A call through the base class: only newer Java has ByteBuffer.clear of its own.
    ((java.nio.Buffer) out).clear();
    return u16(id).u16(0);
  }

  LittleEndianWriter u8(int value) {
    out.put((byte) value);
    return this;
  }

  LittleEndianWriter u16(int value) {
    out.putShort((short) value);
    return this;
  }

  LittleEndianWriter i32(int value) {
    out.putInt(value);
    return this;
  }

  LittleEndianWriter i64(long value) {
    out.putLong(value);
    return this;
  }

  LittleEndianWriter f32(double value) {
    out.putFloat((float) value);
    return this;
  }

  LittleEndianWriter f64(double value) {
    out.putDouble(value);
    return this;
  }

  LittleEndianWriter name(String name) {
    out.put(name.getBytes(StandardCharsets.UTF_8));
    return u8(0);
  }

  /** A string in a field of {@code size} bytes, of which at least one is NUL. */
  LittleEndianWriter fixedName(String name, int size) {
    byte[] text = name.getBytes(StandardCharsets.UTF_8);
    out.put(Arrays.copyOf(Arrays.copyOf(text, size - 1), size));
    return this;
  }

  LittleEndianWriter zeros(int count) {
    out.put(new byte[count]);
    return this;
  }

  /** Reserves a 32-bit size, if {@code isPresent}; returns the argument of {@link #endSection}. */
  int beginSection(boolean isPresent) {
    if (!isPresent) {
      return -1;
    }
    i32(0);
    return out.position();
  }

  /** The section that began at {@code start} ends here. */
  void endSection(int start) {
    if (start >= 0) {
      out.putInt(start - 4, out.position() - start);
    }
  }

  /** The datagram, the size of its payload filled in. */
  byte[] end() {
    out.putShort(2, (short) (out.position() - Message.HEADER_BYTES));
    return Arrays.copyOf(out.array(), out.position());
  }

  /** The error for {@code e}, thrown by a method of this class when a datagram is full. */
  static IllegalStateException tooLong(BufferOverflowException e) {
    return new IllegalStateException(
        "more bodies than a datagram of " + Message.MAX_BYTES + " bytes can hold", e);
  }
}
