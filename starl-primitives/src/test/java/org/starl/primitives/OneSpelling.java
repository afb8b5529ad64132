package org.starl.primitives;

import java.util.Arrays;
import java.util.HexFormat;
import org.starl.platform.Radio;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** What every reader of a message's bytes must do with any bytes. */
public final class OneSpelling {

  private OneSpelling() {}

  /** Reads a value that is nothing but these bytes, or throws. */
  @FunctionalInterface
  public interface Reader<T> {
    T read(WireReader in);
  }

  /** Writes it. */
  @FunctionalInterface
  public interface Writer<T> {
    byte[] write(T value);
  }

  /** {@code input} is refused with a line, or is what {@code codec} writes for what it reads. */
  public static <T> void require(Shape<T> codec, byte[] input) {
    require(codec::read, message -> bytes(codec, message), input);
  }

  /** {@code input} is refused with a line, or is what {@code writer} writes for what is read. */
  public static <T> void require(Reader<T> reader, Writer<T> writer, byte[] input) {
    WireReader in = new WireReader(input);
    T value;
    try {
      value = reader.read(in);
    } catch (WireFormatException | IllegalArgumentException refused) {
      String line = String.valueOf(refused.getMessage());
      if (line.isEmpty() || line.length() > 4000 || line.equals("null")) {
        throw new AssertionError("a bad line: " + line, refused);
      }
      return;
    }
    byte[] read = Arrays.copyOf(input, input.length - in.remaining());
    byte[] written = writer.write(value);
    if (!Arrays.equals(read, written)) {
      throw new AssertionError(value + " is written as " + HexFormat.of().formatHex(written));
    }
    if (value == null || !value.equals(reader.read(new WireReader(written)))) {
      throw new AssertionError(value + " is read as something else");
    }
  }

  /** The value that is nothing but this JSON, as a reader of traces reads it. */
  public static <T> T fromJson(Shape<T> shape, String json) throws JsonFormatException {
    JsonReader in = new JsonReader("json", 1, json);
    T value = shape.readJson(in);
    in.expectEnd();
    return value;
  }

  /** The bytes of a message. */
  public static <T> byte[] bytes(Shape<T> codec, T message) {
    byte[] buffer = new byte[2 * Radio.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    codec.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }
}
