package org.starl.spec.automaton;

import java.util.List;

/** A value of {@code lift[T]}, the PVS prelude's optional type. */
public sealed interface Lift<T> extends Term {

  /** A value. */
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

  /** No value. */
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
