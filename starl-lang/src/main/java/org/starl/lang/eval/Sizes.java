package org.starl.lang.eval;

import java.util.Map;
import java.util.Optional;

/**
 * The sizes of a run.
 *
 * @param opaque the number of elements of each opaque type, by its name
 * @param nat the largest natural number and the largest {@code int}, whose least is {@code -nat};
 *     also the largest length of a list
 * @param time the largest time; also of the real numbers, whose least is {@code -time}
 * @param numbers the values of the parameters that bounds of ranges have
 */
public record Sizes(Map<String, Integer> opaque, int nat, int time, Map<String, Integer> numbers) {

  /** Of an automaton whose ranges have no parameters in their bounds. */
  public Sizes(Map<String, Integer> opaque, int nat, int time) {
    this(opaque, nat, time, Map.of());
  }

  /** The same with values of the parameters that bounds of ranges have. */
  public Sizes with(Map<String, Integer> values) {
    return new Sizes(opaque, nat, time, values);
  }

  /** The value of a parameter, if bounds of ranges have it. */
  Optional<Integer> number(String parameter) {
    return Optional.ofNullable(numbers.get(parameter));
  }

  /** The number of elements of an opaque type. */
  int of(String type) {
    Integer size = opaque.get(type);
    if (size == null) {
      throw new IllegalArgumentException("no size of " + type);
    }
    return size;
  }
}
