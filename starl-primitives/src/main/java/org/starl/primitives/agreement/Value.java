package org.starl.primitives.agreement;

import java.util.Arrays;

/** What is agreed on: bytes that the Synod does not look into. Immutable. */
public final class Value {

  public static final Value EMPTY = new Value(new byte[0]);

  /**
   * The longest value, in bytes: with a ballot, the names of the channel and a datagram's own
   * fields, it still fits one datagram.
   */
  public static final int MAX_BYTES = 1000;

  private static final String HEX = "0123456789abcdef";

  private final byte[] bytes;

  private Value(byte[] bytes) {
    this.bytes = bytes;
  }

  /** A value of the bytes as they are now, at most {@link #MAX_BYTES} of them. */
  public static Value of(byte[] bytes) {
    if (bytes.length > MAX_BYTES) {
      throw new IllegalArgumentException(
          "a value of " + bytes.length + " bytes: expected at most " + MAX_BYTES);
    }
    return new Value(bytes.clone());
  }

  /** The caller's own copy. */
  public byte[] bytes() {
    return bytes.clone();
  }

  public int length() {
    return bytes.length;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Value that && Arrays.equals(bytes, that.bytes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bytes);
  }

  /** In hexadecimal digits. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(2 * bytes.length);
    for (byte b : bytes) {
      text.append(HEX.charAt((b >> 4) & 0xF)).append(HEX.charAt(b & 0xF));
    }
    return text.toString();
  }
}
