package org.starl.shape;

import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * How the values of a type are written: as bytes of a datagram, as JSON in a trace, and in the
 * documentation. Immutable.
 *
 * <p>Reading what was written gives an equal value. A value that a shape cannot write is a bug: {@link
 * IllegalArgumentException}.
 *
 * @param <T> the type; its values are immutable
 */
public interface Shape<T> {

  /** Writes the bytes. */
  void write(T value, WireWriter out);

  /** Reads the bytes; {@link WireFormatException} if they are invalid. */
  T read(WireReader in);

  /** Writes one JSON value. */
  void writeJson(T value, JsonWriter out);

  /** Reads one JSON value, exactly as {@link #writeJson} writes it. */
  T readJson(JsonReader in) throws JsonFormatException;

  /** The type, in documentation: {@code i64}, {@code list of process}. */
  String describe();

  /** Whether JSON that was written can be read back as this type; else it is {@link Shapes#JSON}. */
  default boolean isReadable() {
    return true;
  }

  /** {@code value} as one JSON value. */
  default String json(T value) {
    JsonWriter out = new JsonWriter();
    writeJson(value, out);
    return out.textFrom(0);
  }

  /** This shape with other bytes: a format of its own. */
  default Shape<T> bytes(BiConsumer<T, WireWriter> writer, Function<WireReader, T> reader) {
    return new Leaf<>(describe(), isReadable(), writer, reader, this::writeJson, this::readJson);
  }

  /** The shape of another type, whose values are written as values of this one. */
  default <U> Shape<U> as(String type, Function<U, T> from, Function<T, U> to) {
    return new Leaf<>(
        type,
        isReadable(),
        (v, out) -> write(from.apply(v), out),
        in -> to.apply(read(in)),
        (v, out) -> writeJson(from.apply(v), out),
        in -> {
          T value = readJson(in);
          try {
            return to.apply(value);
          } catch (IllegalArgumentException refused) {
            throw in.refused(refused);
          }
        });
  }

  /**
   * With a condition on values that are read. In records, prefer the constructor.
   *
   * @param check throws an {@link IllegalArgumentException}
   */
  default Shape<T> where(Consumer<? super T> check) {
    return as(
        describe(),
        value -> value,
        value -> {
          check.accept(value);
          return value;
        });
  }
}
