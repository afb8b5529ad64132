package org.starl.shape;

import java.util.function.Function;

/**
 * One part of a record: its name, the shape of its values, and how to get it.
 *
 * @param <T> the record
 * @param <V> the part
 */
public record Part<T, V>(String name, Shape<V> shape, Function<? super T, ? extends V> get) {

  void write(T record, WireWriter out) {
    shape.write(get.apply(record), out);
  }

  void writeJson(T record, JsonWriter out) {
    shape.writeJson(get.apply(record), out);
  }
}
