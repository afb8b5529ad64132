package org.starl.primitives.agreement;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Function;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** The value that a Synod decides on: bytes that it does not interpret. Immutable. */
public final class Value implements Comparable<Value> {

  public static final Value EMPTY = new Value(new byte[0]);

  /**
   * The longest value, in bytes. With a ballot, the channel's names and the datagram's own fields it
   * still fits one datagram.
   */
  public static final int MAX_BYTES = 1000;

  /** Its bytes after their number in two bytes; in JSON its hexadecimal digits. */
  public static final Shape<Value> SHAPE =
      Shapes.<Value>text("value", Value::toString, Value::parse)
          .bytes((value, out) -> out.bytes(value.bytes), in -> of(in.bytes()));

  private static final String HEX = "0123456789abcdef";

  private final byte[] bytes;

  private Value(byte[] bytes) {
    this.bytes = bytes;
  }

  /** A value of a copy of {@code bytes}, at most {@link #MAX_BYTES}. */
  public static Value of(byte[] bytes) {
    if (bytes.length > MAX_BYTES) {
      throw new IllegalArgumentException(
          "a value of " + bytes.length + " bytes: expected at most " + MAX_BYTES);
    }
    return new Value(bytes.clone());
  }

  /** The value that {@code writer} writes. */
  public static Value write(Consumer<WireWriter> writer) {
    byte[] buffer = new byte[MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    writer.accept(out);
    return new Value(Arrays.copyOf(buffer, out.length()));
  }

  /**
   * Reads all bytes.
   *
   * @param what is read, for the error
   * @throws WireFormatException if {@code reader} leaves some, or cannot read them
   */
  public <T> T read(String what, Function<WireReader, T> reader) {
    WireReader in = new WireReader(bytes.clone());
    T read = reader.apply(in);
    if (in.remaining() > 0) {
      throw new WireFormatException(in.remaining() + " bytes after " + what);
    }
    return read;
  }

  /** A copy. */
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

  /** By their bytes, as signed numbers. */
  @Override
  public int compareTo(Value other) {
    return ByteBuffer.wrap(bytes).compareTo(ByteBuffer.wrap(other.bytes));
  }

  private static Value parse(String text) {
    byte[] bytes = new byte[text.length() / 2];
    for (int i = 0; i < bytes.length; i++) {
      int high = HEX.indexOf(text.charAt(2 * i));
      bytes[i] = (byte) (high << 4 | HEX.indexOf(text.charAt(2 * i + 1)));
    }
    Value value = of(bytes);
    if (!value.toString().equals(text)) {
      throw new IllegalArgumentException("value '" + text + "': expected hexadecimal digits");
    }
    return value;
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
