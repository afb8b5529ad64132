package org.starl.spec.automaton;

import java.util.Collections;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
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
  // No value equals the default.
  private final SortedMap<K, V> exceptions;

  private Fun(V defaultValue, SortedMap<K, V> exceptions) {
    this.defaultValue = defaultValue;
    this.exceptions = exceptions;
  }

  /** {@code LAMBDA x: value}. */
  public static <K extends Comparable<? super K>, V> Fun<K, V> always(V value) {
    return new Fun<>(value, new TreeMap<K, V>());
  }

  /** Its value at {@code argument}. */
  public V at(K argument) {
    return exceptions.getOrDefault(argument, defaultValue);
  }

  /** {@code f WITH [(argument) := value]}. */
  public Fun<K, V> with(K argument, V value) {
    if (value.equals(at(argument))) {
      return this;
    }
    SortedMap<K, V> changed = new TreeMap<>(exceptions);
    if (value.equals(defaultValue)) {
      changed.remove(argument);
    } else {
      changed.put(argument, value);
    }
    return new Fun<>(defaultValue, changed);
  }

  /** The default value. */
  public V defaultValue() {
    return defaultValue;
  }

  /** The exceptions' arguments, in order. */
  public Set<K> arguments() {
    return Collections.unmodifiableSet(exceptions.keySet());
  }

  /** The number of exceptions. */
  public int size() {
    return exceptions.size();
  }

  /** Whether it has no exception. */
  public boolean isConstant() {
    return exceptions.isEmpty();
  }

  /** Visits every exception, in order: argument and value. */
  public void forEach(BiConsumer<? super K, ? super V> visitor) {
    exceptions.forEach(visitor);
  }

  /** Whether {@code test} is true of every exception: argument and value. */
  public boolean allMatch(BiPredicate<? super K, ? super V> test) {
    return exceptions.entrySet().stream().allMatch(e -> test.test(e.getKey(), e.getValue()));
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof Fun<?, ?> that
        && defaultValue.equals(that.defaultValue)
        && exceptions.equals(that.exceptions);
  }

  @Override
  public int hashCode() {
    return exceptions.hashCode();
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
