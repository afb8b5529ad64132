package org.starl.primitives.exhaustive;

import java.util.List;
import java.util.function.Function;

/**
 * The states of one protocol's code, within bounds.
 *
 * @param name of the primitive
 * @param meaning what participants may do, in one sentence
 * @param goal what holds in the states that the protocol is there for
 * @param bounds in order
 * @param search makes a search; its argument is one number for each bound, in their order
 */
public record StateSpace(
    String name,
    String meaning,
    String goal,
    List<Bound> bounds,
    Function<List<Integer>, StateSearch<?, ?, ?>> search) {

  /**
   * A number that bounds the states.
   *
   * @param least the smallest value, and {@code most} the largest
   * @param usual the value if none is given
   */
  public record Bound(String name, String meaning, int least, int usual, int most) {}
}
