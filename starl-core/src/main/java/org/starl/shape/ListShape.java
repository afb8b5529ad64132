package org.starl.shape;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/** Lists, with their length in front. */
record ListShape<E>(Shape<E> element, int most) implements Shape<List<E>> {

  private static final int BYTE = 0xFF;

  static <E extends Comparable<? super E>> Shape<SortedSet<E>> set(Shape<E> element, int most) {
    ListShape<E> list = new ListShape<>(element, most);
    return list.as("set of " + element.describe(), List::copyOf, ListShape::sorted);
  }

  // Only in ascending order, so that equal values have equal bytes.
  private static <E extends Comparable<? super E>> SortedSet<E> sorted(List<E> list) {
    TreeSet<E> set = new TreeSet<>();
    for (E each : list) {
      requireAfter(set, each);
      set.add(each);
    }
    return Collections.unmodifiableSortedSet(set);
  }

  /** A key and its value. */
  private record Entry<K, V>(K key, V value) {}

  static <K extends Comparable<? super K>, V> Shape<SortedMap<K, V>> map(
      Shape<K> key, Shape<V> value, int most) {
    Shape<Entry<K, V>> entry =
        Shapes.of(
            ListShape.<Entry<K, V>>type(),
            Shapes.part("key", key, Entry::key),
            Shapes.part("value", value, Entry::value),
            Entry::new);
    ListShape<Entry<K, V>> list = new ListShape<>(entry, most);
    return list.as(
        "map from " + key.describe() + " to " + value.describe(),
        ListShape::entries,
        ListShape::sortedMap);
  }

  @SuppressWarnings("unchecked") // a class object has no type arguments
  private static <T> Class<T> type() {
    return (Class<T>) Entry.class;
  }

  private static <K, V> List<Entry<K, V>> entries(SortedMap<K, V> map) {
    List<Entry<K, V>> entries = new ArrayList<>(map.size());
    for (Map.Entry<K, V> each : map.entrySet()) {
      entries.add(new Entry<>(each.getKey(), each.getValue()));
    }
    return entries;
  }

  private static <K extends Comparable<? super K>, V> SortedMap<K, V> sortedMap(
      List<Entry<K, V>> entries) {
    TreeMap<K, V> map = new TreeMap<>();
    for (Entry<K, V> entry : entries) {
      requireAfter(map.navigableKeySet(), entry.key);
      map.put(entry.key, entry.value);
    }
    return Collections.unmodifiableSortedMap(map);
  }

  private static <E extends Comparable<? super E>> void requireAfter(SortedSet<E> set, E next) {
    if (!set.isEmpty() && set.last().compareTo(next) >= 0) {
      throw new IllegalArgumentException(next + " after " + set.last());
    }
  }

  @Override
  public void write(List<E> values, WireWriter out) {
    if (most <= BYTE) {
      out.u8(values.size());
    } else {
      out.u16(values.size());
    }
    for (E value : values) {
      element.write(value, out);
    }
  }

  @Override
  public List<E> read(WireReader in) {
    int count = most <= BYTE ? in.u8() : in.u16();
    if (count > most) {
      throw new WireFormatException(count + " of " + element.describe());
    }
    List<E> values = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      values.add(element.read(in));
    }
    return Collections.unmodifiableList(values);
  }

  @Override
  public void writeJson(List<E> values, JsonWriter out) {
    char before = '[';
    for (E value : values) {
      out.ascii(before);
      element.writeJson(value, out);
      before = ',';
    }
    out.ascii(values.isEmpty() ? "[]" : "]");
  }

  @Override
  public List<E> readJson(JsonReader in) throws JsonFormatException {
    in.expect("[");
    List<E> values = new ArrayList<>();
    if (!in.take("]")) {
      do {
        values.add(element.readJson(in));
      } while (in.take(","));
      in.expect("]");
    }
    return Collections.unmodifiableList(values);
  }

  @Override
  public boolean isReadable() {
    return element.isReadable();
  }

  @Override
  public String describe() {
    return "list of " + element.describe();
  }
}
