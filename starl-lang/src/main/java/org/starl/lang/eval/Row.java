package org.starl.lang.eval;

import java.util.Arrays;
import java.util.List;

/** Values in order: of a record, a map, a list, a state. */
public final class Row {

  static final Row EMPTY = new Row();

  private final Object[] items;
  private int hash;

  /** Owns {@code items}. */
  Row(Object... items) {
    this.items = items;
  }

  /** A row of these values. */
  public static Row of(List<?> values) {
    return new Row(values.toArray());
  }

  /** The value at this place, from 0. */
  public Object get(int place) {
    return items[place];
  }

  /** The number of values. */
  public int size() {
    return items.length;
  }

  /** Not to be changed. */
  Object[] items() {
    return items;
  }

  /** With another value at {@code place}. */
  Row with(int place, Object value) {
    Object[] changed = items.clone();
    changed[place] = value;
    return new Row(changed);
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || (other instanceof Row that
            && hashCode() == that.hashCode()
            && Arrays.equals(items, that.items));
  }

  @Override
  public int hashCode() {
    if (hash == 0) {
      hash = Arrays.hashCode(items);
    }
    return hash;
  }

  @Override
  public String toString() {
    return Arrays.toString(items);
  }
}
