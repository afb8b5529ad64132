package org.starl.primitives.exhaustive;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToIntFunction;

/**
 * The states of one protocol's code, within bounds.
 *
 * @param name of the primitive
 * @param goal what holds in the states that the protocol is there for
 * @param search makes a search; its argument gives the number of each bound, by name
 */
public record StateSpace(
    String name,
    String goal,
    List<Bound> bounds,
    Function<ToIntFunction<String>, StateSearch<?, ?, ?>> search) {

  /**
   * A number that bounds the states.
   *
   * @param least the smallest value, and {@code most} the largest
   * @param usual the value if none is given
   */
  public record Bound(String name, String meaning, int least, int usual, int most) {}
}
