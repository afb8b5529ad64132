package org.starl.cli;

import java.security.SecureRandom;
import org.jspecify.annotations.Nullable;
import org.starl.sim.BadInput;
import org.starl.sim.Quantities;

/** Seeds as people give them. */
final class Seeds {

  private static final int DRAWN_BELOW = 1_000_000;

  private Seeds() {}

  /** The seed that {@code text} says; a drawn one, small enough to type, if it says nothing. */
  static long of(@Nullable String text) {
    if (text == null) {
      return new SecureRandom().nextInt(DRAWN_BELOW);
    }
    try {
      return Quantities.whole(text, Long.MIN_VALUE, Long.MAX_VALUE);
    } catch (BadInput error) {
      throw Quantities.in("--seed", error);
    }
  }

  /** {@code A..B}. */
  record Range(long first, long last) {

    static Range of(String text) {
      int dots = text.indexOf("..");
      try {
        long first =
            Quantities.whole(dots < 0 ? text : text.substring(0, dots), 0, Integer.MAX_VALUE);
        long last =
            dots < 0 ? first : Quantities.whole(text.substring(dots + 2), 0, Integer.MAX_VALUE);
        if (first <= last) {
          return new Range(first, last);
        }
      } catch (BadInput notNumbers) {
        throw new BadInput(
            "--seeds: " + BadInput.quote(text) + ": expected A..B with 0 <= A <= B < 2^31");
      }
      throw new BadInput(
          "--seeds: " + BadInput.quote(text) + ": expected A..B with 0 <= A <= B < 2^31");
    }
  }
}
