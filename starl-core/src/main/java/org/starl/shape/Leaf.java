package org.starl.shape;

import java.util.function.BiConsumer;
import java.util.function.Function;

/** A shape of four functions. */
record Leaf<T>(
    String describe,
    boolean isReadable,
    BiConsumer<T, WireWriter> writer,
    Function<WireReader, ? extends T> reader,
    BiConsumer<T, JsonWriter> jsonWriter,
    JsonRead<T> jsonReader)
    implements Shape<T> {

  /** A readable one. */
  Leaf(
      String describe,
      BiConsumer<T, WireWriter> writer,
      Function<WireReader, ? extends T> reader,
      BiConsumer<T, JsonWriter> jsonWriter,
      JsonRead<T> jsonReader) {
    this(describe, true, writer, reader, jsonWriter, jsonReader);
  }

  /** Reads one JSON value. */
  @FunctionalInterface
  interface JsonRead<T> {
    T from(JsonReader in) throws JsonFormatException;
  }

  @Override
  public void write(T value, WireWriter out) {
    writer.accept(value, out);
  }

  @Override
  public T read(WireReader in) {
    try {
      return reader.apply(in);
    } catch (IllegalArgumentException refused) {
      throw new WireFormatException(String.valueOf(refused.getMessage()));
    }
  }

  @Override
  public void writeJson(T value, JsonWriter out) {
    jsonWriter.accept(value, out);
  }

  @Override
  public T readJson(JsonReader in) throws JsonFormatException {
    return jsonReader.from(in);
  }

  static void writeBool(boolean value, JsonWriter out) {
    out.ascii(value ? "true" : "false");
  }

  static boolean readBool(JsonReader in) throws JsonFormatException {
    if (in.take("true")) {
      return true;
    }
    in.expect("false");
    return false;
  }
}
