package org.starl.spec.automaton;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;

/** Immutable finite sets as values of a theory, under the names of the prelude's functions. */
public final class Sets {

  private Sets() {}

  /** The empty set. */
  public static <T> SortedSet<T> emptyset() {
    return Collections.unmodifiableSortedSet(new TreeSet<>());
  }

  /** The set of {@code x}. */
  public static <T> SortedSet<T> singleton(T x) {
    return add(x, emptyset());
  }

  /** {@code set} and {@code x}. */
  public static <T> SortedSet<T> add(T x, Collection<? extends T> set) {
    SortedSet<T> more = new TreeSet<>(set);
    more.add(x);
    return Collections.unmodifiableSortedSet(more);
  }

  /** {@code set} without {@code x}. */
  public static <T> SortedSet<T> remove(T x, Collection<? extends T> set) {
    SortedSet<T> less = new TreeSet<>(set);
    less.remove(x);
    return Collections.unmodifiableSortedSet(less);
  }
}
