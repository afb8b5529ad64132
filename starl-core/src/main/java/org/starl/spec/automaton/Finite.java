package org.starl.spec.automaton;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.LongStream;
import java.util.stream.StreamSupport;

/**
 * Conditions on all values of an infinite type that are evaluated at finitely many of them: the
 * elements of {@code where}. At all other values they are the same. A value may occur more than once.
 */
public final class Finite {

  private Finite() {}

  /** Whether {@code condition} is true at all elements of {@code where}. */
  @SafeVarargs
  public static <T> boolean forAll(Predicate<? super T> condition, Iterable<? extends T>... where) {
    for (Iterable<? extends T> values : where) {
      for (T value : values) {
        if (!condition.test(value)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Whether {@code condition} is true at an element of {@code where}. */
  @SafeVarargs
  public static <T> boolean exists(Predicate<? super T> condition, Iterable<? extends T>... where) {
    for (Iterable<? extends T> values : where) {
      for (T value : values) {
        if (condition.test(value)) {
          return true;
        }
      }
    }
    return false;
  }

  /** The whole numbers from {@code from} to {@code to}. */
  public static Iterable<Long> range(long from, long to) {
    return () -> LongStream.rangeClosed(from, to).iterator();
  }

  /** The {@code numbers} that are at least 0: the others are no values of {@code nat}, {@code time}. */
  public static <N extends Number> Iterable<N> notNegative(Iterable<N> numbers) {
    return () ->
        StreamSupport.stream(numbers.spliterator(), false)
            .filter(each -> each.doubleValue() >= 0)
            .iterator();
  }

  /** The elements of {@code where} at which {@code condition} is true. */
  @SafeVarargs
  public static <T> SortedSet<T> suchThat(
      Predicate<? super T> condition, Iterable<? extends T>... where) {
    List<T> those = new ArrayList<>();
    for (Iterable<? extends T> values : where) {
      for (T value : values) {
        if (condition.test(value)) {
          those.add(value);
        }
      }
    }
    return Sets.of(those);
  }

  /**
   * The function that is {@code function} at the elements of {@code where}, and else {@code
   * elsewhere}. Both may have the same values.
   */
  @SafeVarargs
  public static <K extends Comparable<? super K>, V> Fun<K, V> map(
      Fun<K, V> elsewhere,
      Function<? super K, ? extends V> function,
      Iterable<? extends K>... where) {
    Fun<K, V> map = elsewhere;
    for (Iterable<? extends K> arguments : where) {
      for (K argument : arguments) {
        map = map.with(argument, function.apply(argument));
      }
    }
    return map;
  }

  /** The text of the first element of {@code where} at which {@code condition} is true; else empty. */
  @SafeVarargs
  public static <T> String first(
      Predicate<? super T> condition,
      Function<? super T, String> text,
      Iterable<? extends T>... where) {
    for (Iterable<? extends T> values : where) {
      for (T value : values) {
        if (condition.test(value)) {
          return text.apply(value);
        }
      }
    }
    return "";
  }
}
