package org.starl.shape;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The shape of a record: its parts in their order. Bytes: the parts' bytes. JSON: an object.
 *
 * @param <T> the record
 */
public class RecordShape<T> implements Shape<T> {

  /** Reads the parts of a record, in their order. */
  interface Source {
    <V> V next(Part<?, V> part) throws JsonFormatException;
  }

  /** Makes a record of what it reads. */
  interface Make<T> {
    T from(Source source) throws JsonFormatException;
  }

  private final String name;
  private final Class<T> type;
  private final List<Part<T, ?>> parts;
  private final Make<T> make;

  RecordShape(String name, Class<T> type, List<Part<T, ?>> parts, Make<T> make) {
    this.name = name;
    this.type = type;
    this.parts = List.copyOf(parts);
    this.make = make;
  }

  /** The same with another name, such as the paper's {@code do_mutex}. */
  public RecordShape<T> named(String newName) {
    return new RecordShape<>(newName, type, parts, make);
  }

  /** The record's name; by default that of its class. */
  public String name() {
    return name;
  }

  /** A record of which only the name is known: its values are JSON objects. */
  public static RecordShape<Json> unknown(String name) {
    return new RecordShape<>(name, Json.class, List.of(), in -> new Json("{}")) {
      @Override
      public void writeJson(Json value, JsonWriter out) {
        out.value(value.text());
      }

      @Override
      public Json readJson(JsonReader in) throws JsonFormatException {
        return new Json(in.value());
      }

      @Override
      public List<Object> values(Object value) {
        return List.of(value);
      }
    };
  }

  /** The record's class. */
  public Class<T> type() {
    return type;
  }

  /** The parts, in their order. */
  public List<Part<T, ?>> parts() {
    return parts;
  }

  /** The values of the parts of {@code value}, in their order: for people. */
  public List<Object> values(Object value) {
    T record = type.cast(value);
    List<Object> values = new ArrayList<>(parts.size());
    for (Part<T, ?> part : parts) {
      values.add(part.get().apply(record));
    }
    return values;
  }

  /** The value of the first part; null if there is none. */
  public @Nullable Object first(Object value) {
    return parts.isEmpty() ? null : parts.get(0).get().apply(type.cast(value));
  }

  @Override
  public void write(T value, WireWriter out) {
    for (Part<T, ?> part : parts) {
      part.write(value, out);
    }
  }

  @Override
  public T read(WireReader in) {
    try {
      return make.from(new Bytes(in));
    } catch (IllegalArgumentException refused) {
      throw new WireFormatException(String.valueOf(refused.getMessage()));
    } catch (JsonFormatException e) {
      throw new AssertionError(e); // bytes are no JSON
    }
  }

  private record Bytes(WireReader in) implements Source {
    @Override
    public <V> V next(Part<?, V> part) {
      return part.shape().read(in);
    }
  }

  @Override
  public void writeJson(T value, JsonWriter out) {
    char before = '{';
    for (Part<T, ?> part : parts) {
      out.ascii(before);
      out.string(part.name());
      out.ascii(':');
      part.writeJson(value, out);
      before = ',';
    }
    out.ascii(parts.isEmpty() ? "{}" : "}");
  }

  @Override
  public T readJson(JsonReader in) throws JsonFormatException {
    T read;
    try {
      in.expect("{");
      read = make.from(new Text(in));
    } catch (IllegalArgumentException refused) {
      throw in.refused(refused);
    }
    in.expect("}");
    return read;
  }

  private static final class Text implements Source {
    private final JsonReader in;
    private boolean isLater;

    Text(JsonReader in) {
      this.in = in;
    }

    @Override
    public <V> V next(Part<?, V> part) throws JsonFormatException {
      in.expect((isLater ? ",\"" : "\"") + part.name() + "\":");
      isLater = true;
      return part.shape().readJson(in);
    }
  }

  @Override
  public boolean isReadable() {
    return parts.stream().allMatch(part -> part.shape().isReadable());
  }

  /** {@code Ok(from: process, num: i64)}. */
  @Override
  public String describe() {
    StringBuilder text = new StringBuilder(name).append('(');
    String comma = "";
    for (Part<T, ?> part : parts) {
      text.append(comma).append(part.name()).append(": ").append(part.shape().describe());
      comma = ", ";
    }
    return text.append(')').toString();
  }

  @Override
  public String toString() {
    return describe();
  }
}
