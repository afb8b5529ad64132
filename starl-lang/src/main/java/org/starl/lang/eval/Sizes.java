package org.starl.lang.eval;

import java.util.Map;

/**
 * The sizes of a run.
 *
 * @param opaque the number of elements of each opaque type, by its name
 * @param nat the largest natural number and the largest {@code int}, whose least is {@code -nat};
 *     also the largest length of a list
 * @param time the largest time; also of the real numbers, whose least is {@code -time}
 */
public record Sizes(Map<String, Integer> opaque, int nat, int time) {

  /** The number of elements of an opaque type. */
  int of(String type) {
    Integer size = opaque.get(type);
    if (size == null) {
      throw new IllegalArgumentException("no size of " + type);
    }
    return size;
  }
}
