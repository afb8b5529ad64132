package org.starl.sim.replay;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.RandomAccess;
import org.jspecify.annotations.Nullable;

/**
 * A list that one thread appends to while others read the elements counted by {@link #size}.
 * Elements are never moved or removed, and no lock is used.
 */
final class Chunks<T> {

  private static final int SHIFT = 12;
  private static final int CHUNK = 1 << SHIFT;

  // Written before the size, which is volatile, and read after it.
  private volatile Object[][] chunks = new Object[16][];
  private volatile int size;

  /** Only ever called by one thread. */
  void add(T item) {
    int index = size;
    if (index == Integer.MAX_VALUE) {
      throw new IllegalStateException("a list of 2^31 - 1 items is full");
    }
    int number = index >>> SHIFT;
    Object[][] all = chunks;
    if (number == all.length) {
      all = Arrays.copyOf(all, 2 * number);
      chunks = all;
    }
    if (all[number] == null) {
      all[number] = new Object[CHUNK];
    }
    all[number][index & (CHUNK - 1)] = item;
    size = index + 1;
  }

  int size() {
    return size;
  }

  // Only elements stored by add() are here.
  @SuppressWarnings("unchecked")
  T get(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("number " + index + " of " + size);
    }
    return (T) chunks[index >>> SHIFT][index & (CHUNK - 1)];
  }

  /** A snapshot of the current elements. */
  List<T> view() {
    return new View(size);
  }

  private final class View extends AbstractList<T> implements RandomAccess {
    private final int viewed;

    View(int viewed) {
      this.viewed = viewed;
    }

    @Override
    public T get(int index) {
      if (index >= viewed) {
        throw new IndexOutOfBoundsException("number " + index + " of " + viewed);
      }
      return Chunks.this.get(index);
    }

    @Override
    public int size() {
      return viewed;
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return super.equals(other);
    }

    @Override
    public int hashCode() {
      return super.hashCode();
    }
  }
}
