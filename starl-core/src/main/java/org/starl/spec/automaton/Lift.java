package org.starl.spec.automaton;

import java.util.List;

/** A value of {@code lift[T]}, the prelude's type of something or nothing. */
public sealed interface Lift<T> extends Term {

  /** Something. */
  record up<T>(T value) implements Lift<T> {
    @Override
    public List<Object> args() {
      return List.of(value);
    }

    @Override
    public String toString() {
      return text();
    }
  }

  /** Nothing. */
  record bottom<T>() implements Lift<T> {
    @Override
    public List<Object> args() {
      return List.of();
    }

    @Override
    public String toString() {
      return text();
    }
  }

  default boolean isUp() {
    return this instanceof up;
  }
}
