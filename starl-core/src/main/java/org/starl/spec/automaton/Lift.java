package org.starl.spec.automaton;

import java.util.List;

/** A value of {@code lift[T]}, the prelude's type of an optional value. */
public sealed interface Lift<T> extends Term {

  /** A value. */
  record up<T>(T value) implements Lift<T> {
    @Override
    public String toString() {
      return text();
    }
  }

  /** No value. */
  record bottom<T>() implements Lift<T> {
    @Override
    public String toString() {
      return text();
    }
  }

  default boolean isUp() {
    return this instanceof up;
  }

  /**
   * The value.
   *
   * @throws IllegalStateException if there is none
   */
  default T get() {
    if (this instanceof up<T> known) {
      return known.value;
    }
    throw new IllegalStateException("no value");
  }

  @Override
  default List<Object> args() {
    return this instanceof up<T> known ? List.of(known.value) : List.of();
  }
}
