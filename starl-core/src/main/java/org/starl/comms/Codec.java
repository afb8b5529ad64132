package org.starl.comms;

import java.util.function.BiConsumer;
import java.util.function.Function;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.JsonWriter;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/**
 * A shape of bytes alone, for messages that no monitor reads: a trace has their {@code toString}.
 * {@code read(write(m))} equals {@code m}. {@code read} throws {@link WireFormatException} for bytes
 * that {@code write} cannot have written, as {@link WireReader}'s methods do; an {@link
 * IllegalArgumentException} from a value's constructor has the same effect.
 */
public interface Codec<T> extends Shape<T> {

  /** Texts, as UTF-8 to the end of the message. */
  static Shape<String> text() {
    return Shapes.text("text", text -> text, text -> text);
  }

  /** A codec of two functions, for messages of a few fields. */
  static <T> Codec<T> of(BiConsumer<T, WireWriter> writer, Function<WireReader, T> reader) {
    return new Codec<>() {
      @Override
      public void write(T message, WireWriter out) {
        writer.accept(message, out);
      }

      @Override
      public T read(WireReader in) {
        return reader.apply(in);
      }
    };
  }

  @Override
  default void writeJson(T message, JsonWriter out) {
    out.string(message.toString());
  }

  @Override
  default T readJson(JsonReader in) throws JsonFormatException {
    throw in.expected("a message of known shape");
  }

  @Override
  default boolean isReadable() {
    return false;
  }

  @Override
  default String describe() {
    return "bytes";
  }
}
