package org.starl.comms;

import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * Encodes and decodes one channel's messages. {@code read(write(m))} equals {@code m}. {@code read}
 * throws {@link WireFormatException} for bytes that {@code write} cannot have written, as {@link
 * WireReader}'s methods do; an {@link IllegalArgumentException} from a value's constructor has the
 * same effect.
 */
public interface Codec<T> {

  void write(T message, WireWriter out);

  T read(WireReader in);

  /** Texts, as UTF-8 to the end of the message. */
  static Codec<String> text() {
    return of((text, out) -> out.text(text), WireReader::text);
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
}
