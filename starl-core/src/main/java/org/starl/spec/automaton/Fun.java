package org.starl.spec.automaton;

import java.util.Arrays;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import org.jspecify.annotations.Nullable;

/**
 * A total function in a state of a theory, {@code [PIDS -> Zoneset]}: a default value, and finitely
 * many exceptions. Immutable. Memory, and the time of a change, grow with the exceptions only.
 *
 * @param <K> arguments, in their natural order
 * @param <V> compared by {@code equals}
 */
public final class Fun<K extends Comparable<? super K>, V> {

  private final V defaultValue;
  // Parallel arrays: arguments ascend, and no value equals the default.
  private final Object[] arguments;
  private final Object[] values;

  private Fun(V elsewhere, Object[] arguments, Object[] values) {
    this.defaultValue = elsewhere;
    this.arguments = arguments;
    this.values = values;
  }

  /** {@code LAMBDA x: value}. */
  public static <K extends Comparable<? super K>, V> Fun<K, V> always(V value) {
    return new Fun<>(value, new Object[0], new Object[0]);
  }

  /** Its value at {@code argument}. */
  public V at(K argument) {
    int place = place(argument);
    return place < 0 ? defaultValue : value(place);
  }

  /** {@code f WITH [(argument) := value]}. */
  public Fun<K, V> with(K argument, V value) {
    int place = place(argument);
    if (value.equals(defaultValue)) {
      return place < 0 ? this : new Fun<>(defaultValue, cut(arguments, place), cut(values, place));
    }
    if (place >= 0) {
      Object[] changed = values.clone();
      changed[place] = value;
      return new Fun<>(defaultValue, arguments, changed);
    }
    int before = -place - 1;
    return new Fun<>(defaultValue, put(arguments, before, argument), put(values, before, value));
  }

  /** The default value. */
  public V defaultValue() {
    return defaultValue;
  }

  /** The number of exceptions. */
  public int size() {
    return arguments.length;
  }

  /** Whether it has no exception. */
  public boolean isConstant() {
    return arguments.length == 0;
  }

  /** Visits every exception, in order: argument and value. */
  public void forEach(BiConsumer<? super K, ? super V> visitor) {
    for (int place = 0; place < arguments.length; place++) {
      visitor.accept(argument(place), value(place));
    }
  }

  /** Whether {@code test} is true of every exception: argument and value. */
  public boolean allMatch(BiPredicate<? super K, ? super V> test) {
    for (int place = 0; place < arguments.length; place++) {
      if (!test.test(argument(place), value(place))) {
        return false;
      }
    }
    return true;
  }

  private int place(K argument) {
    int from = 0;
    int to = arguments.length - 1;
    while (from <= to) {
      int middle = (from + to) >>> 1;
      int order = argument(middle).compareTo(argument);
      if (order == 0) {
        return middle;
      }
      if (order < 0) {
        from = middle + 1;
      } else {
        to = middle - 1;
      }
    }
    return -from - 1;
  }

  // Safe: only with() fills the arrays.
  @SuppressWarnings("unchecked")
  private K argument(int place) {
    return (K) arguments[place];
  }

  // Safe: only with() fills the arrays.
  @SuppressWarnings("unchecked")
  private V value(int place) {
    return (V) values[place];
  }

  private static Object[] cut(Object[] row, int place) {
    Object[] shorter = Arrays.copyOf(row, row.length - 1);
    System.arraycopy(row, place + 1, shorter, place, shorter.length - place);
    return shorter;
  }

  private static Object[] put(Object[] row, int place, Object what) {
    Object[] longer = Arrays.copyOf(row, row.length + 1);
    System.arraycopy(row, place, longer, place + 1, row.length - place);
    longer[place] = what;
    return longer;
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof Fun<?, ?> that
        && defaultValue.equals(that.defaultValue)
        && Arrays.equals(arguments, that.arguments)
        && Arrays.equals(values, that.values);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(arguments) + Arrays.hashCode(values);
  }

  /** {@code (bot0: [A, C], bot1: [B])}: the exceptions. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("(");
    forEach((argument, value) ->
        text.append(text.length() > 1 ? ", " : "").append(argument).append(": ").append(value));
    return text.append(')').toString();
  }
}
