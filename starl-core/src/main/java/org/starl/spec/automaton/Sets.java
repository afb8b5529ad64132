package org.starl.spec.automaton;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

/** Immutable finite sets, and lists, as values of a theory, under the names of the prelude's functions. */
public final class Sets {

  static final Comparator<Object> ORDER = Sets::compare;

  private Sets() {}

  /**
   * An order of the values of a type: their own, if they have one; of terms, that of their names and
   * arguments; of sets, lists and functions, that of what they are made of.
   */
  @SuppressWarnings("unchecked") // both are of one type
  public static int compare(Object a, Object b) {
    if (a instanceof Term one && b instanceof Term other) {
      int order = one.name().compareTo(other.name());
      return order == 0 ? compare(one.args(), other.args()) : order;
    }
    if (a instanceof Fun<?, ?> one && b instanceof Fun<?, ?> other) {
      return compare(parts(one), parts(other));
    }
    if (a instanceof Collection<?> one && b instanceof Collection<?> other) {
      Iterator<?> rest = other.iterator();
      for (Object each : one) {
        int order = rest.hasNext() ? compare(each, rest.next()) : 1;
        if (order != 0) {
          return order;
        }
      }
      return rest.hasNext() ? -1 : 0;
    }
    return ((Comparable<Object>) a).compareTo(b);
  }

  private static List<Object> parts(Fun<?, ?> of) {
    List<Object> parts = new ArrayList<>();
    parts.add(of.defaultValue());
    of.forEach((argument, value) -> parts.addAll(List.of(argument, value)));
    return parts;
  }

  /** A set of its own with these elements. */
  static <T> TreeSet<T> copy(Collection<? extends T> elements) {
    TreeSet<T> copy = new TreeSet<>(ORDER);
    copy.addAll(elements);
    return copy;
  }

  /** The empty set. */
  public static <T> SortedSet<T> emptyset() {
    return new TreeOfElements<>(null);
  }

  /** The set of {@code x}. */
  public static <T> SortedSet<T> singleton(T x) {
    return new TreeOfElements<T>(null).with(x);
  }

  /** {@code set} and {@code x}. */
  public static <T> SortedSet<T> add(T x, Collection<? extends T> set) {
    return Sets.<T>tree(set).with(x);
  }

  /** {@code set} without {@code x}. */
  public static <T> SortedSet<T> remove(T x, Collection<? extends T> set) {
    return Sets.<T>tree(set).without(x);
  }

  @SuppressWarnings("unchecked") // never changed
  private static <T> TreeOfElements<T> tree(Collection<? extends T> elements) {
    return elements instanceof TreeOfElements<? extends T> tree
        ? (TreeOfElements<T>) tree
        : new TreeOfElements<>(Tree.of(List.copyOf(Sets.<T>copy(elements)), true));
  }

  private static <T> TreeOfElements<T> with(
      TreeOfElements<T> tree, Collection<? extends T> elements) {
    TreeOfElements<T> more = tree;
    for (T each : elements) {
      more = more.with(each);
    }
    return more;
  }

  /** The list of the elements of both. */
  public static <T> List<T> append(List<? extends T> a, List<? extends T> b) {
    List<T> both = new ArrayList<>(a);
    both.addAll(b);
    return Collections.unmodifiableList(both);
  }

  /** The set of {@code elements}. */
  public static <T> SortedSet<T> of(Collection<? extends T> elements) {
    return tree(elements);
  }

  /** The elements of one or both. */
  public static <T> SortedSet<T> union(SortedSet<T> a, SortedSet<T> b) {
    return a.size() < b.size() ? with(tree(b), a) : with(tree(a), b);
  }

  /** The elements of {@code a} that are not in {@code b}. */
  public static <T> SortedSet<T> difference(SortedSet<T> a, SortedSet<T> b) {
    TreeOfElements<T> less = tree(a);
    for (T each : b) {
      less = less.without(each);
    }
    return less;
  }

  /** The elements of both. */
  public static <T> SortedSet<T> intersection(SortedSet<T> a, SortedSet<T> b) {
    return difference(a, difference(a, b));
  }

  /** Whether no element is in both. */
  public static <T> boolean disjoint(SortedSet<T> a, SortedSet<T> b) {
    return Collections.disjoint(a, b);
  }
}
