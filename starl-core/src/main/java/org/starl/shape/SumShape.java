package org.starl.shape;

import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * The shape of a sealed interface: one of several records. Bytes: the record's number in one byte,
 * then the record. JSON: an object with one key, the record's name: {@code {"Ok":{"num":3}}}.
 *
 * @param <T> the sealed interface
 */
public final class SumShape<T> implements Shape<T> {

  private final String what;
  private final List<RecordShape<? extends T>> records;

  SumShape(String what, List<RecordShape<? extends T>> records) {
    this.what = what;
    this.records = records;
  }

  /** All records; the first has number 1. */
  public List<RecordShape<? extends T>> records() {
    return records;
  }

  /** The shape of the record that {@code value} is. */
  public RecordShape<? extends T> caseOf(Object value) {
    return records.get(index(value));
  }

  // They are few, so that a search of all is fast.
  private int index(Object value) {
    for (int i = 0; i < records.size(); i++) {
      if (records.get(i).type() == value.getClass()) {
        return i;
      }
    }
    throw new IllegalArgumentException(
        what + ": no shape for " + value.getClass().getName() + "; expected one of " + describe());
  }

  @Override
  public void write(T value, WireWriter out) {
    int index = index(value);
    out.u8(index + 1);
    write(records.get(index), value, out);
  }

  private static <R> void write(RecordShape<R> shape, Object value, WireWriter out) {
    shape.write(shape.type().cast(value), out);
  }

  @Override
  public T read(WireReader in) {
    int number = in.u8();
    if (number < 1 || number > records.size()) {
      throw new WireFormatException(what + " kind " + number);
    }
    return records.get(number - 1).read(in);
  }

  @Override
  public void writeJson(T value, JsonWriter out) {
    writeJson(caseOf(value), value, out);
  }

  private static <R> void writeJson(RecordShape<R> shape, Object value, JsonWriter out) {
    out.ascii('{');
    out.string(shape.name());
    out.ascii(':');
    shape.writeJson(shape.type().cast(value), out);
    out.ascii('}');
  }

  @Override
  public T readJson(JsonReader in) throws JsonFormatException {
    String name = in.text("{");
    in.expect(":");
    RecordShape<? extends T> found = named(name);
    if (found == null) {
      throw in.unknown(what, name);
    }
    T value = found.readJson(in);
    in.expect("}");
    return value;
  }

  private @Nullable RecordShape<? extends T> named(String name) {
    for (RecordShape<? extends T> each : records) {
      if (each.name().equals(name)) {
        return each;
      }
    }
    return null;
  }

  @Override
  public boolean isReadable() {
    return records.stream().allMatch(Shape::isReadable);
  }

  @Override
  public String describe() {
    return records.stream().map(RecordShape::name).collect(Collectors.joining(" or "));
  }

  @Override
  public String toString() {
    return what + ": " + describe();
  }
}
