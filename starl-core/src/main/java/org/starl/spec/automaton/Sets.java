package org.starl.spec.automaton;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

/** Immutable finite sets, and lists, as values of a theory, under the names of the prelude's functions. */
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

  /** The list of the elements of both. */
  public static <T> List<T> append(List<? extends T> a, List<? extends T> b) {
    List<T> both = new ArrayList<>(a);
    both.addAll(b);
    return Collections.unmodifiableList(both);
  }

  /** The set of {@code elements}. */
  public static <T> SortedSet<T> of(Collection<? extends T> elements) {
    return Collections.unmodifiableSortedSet(new TreeSet<>(elements));
  }

  /** The elements of one or both. */
  public static <T> SortedSet<T> union(SortedSet<T> a, SortedSet<T> b) {
    if (a.isEmpty() || b.isEmpty()) {
      return a.isEmpty() ? b : a;
    }
    SortedSet<T> both = new TreeSet<>(a);
    both.addAll(b);
    return Collections.unmodifiableSortedSet(both);
  }

  /** The elements of {@code a} that are not in {@code b}. */
  public static <T> SortedSet<T> difference(SortedSet<T> a, SortedSet<T> b) {
    SortedSet<T> less = new TreeSet<>(a);
    less.removeAll(b);
    return Collections.unmodifiableSortedSet(less);
  }

  /** The elements of both. */
  public static <T> SortedSet<T> intersection(SortedSet<T> a, SortedSet<T> b) {
    SortedSet<T> both = new TreeSet<>(a);
    both.retainAll(b);
    return Collections.unmodifiableSortedSet(both);
  }

  /** Whether no element is in both. */
  public static <T> boolean disjoint(SortedSet<T> a, SortedSet<T> b) {
    return Collections.disjoint(a, b);
  }
}
