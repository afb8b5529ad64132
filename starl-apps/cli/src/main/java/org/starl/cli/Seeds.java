package org.starl.cli;

import java.security.SecureRandom;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Seeds as people give them. */
final class Seeds {

  private static final int DRAWN_BELOW = 1_000_000;

  private Seeds() {}

  /** The seed that {@code text} says; a drawn one, small enough to type, if it says nothing. */
  static long of(@Nullable String text) {
    if (text == null) {
      return new SecureRandom().nextInt(DRAWN_BELOW);
    }
    return Numbers.whole("--seed", text, Long.MIN_VALUE, Long.MAX_VALUE);
  }

  /** {@code A..B}. */
  record Range(long first, long last) {

    private static final int MOST_RUNS = 10_000_000;

    /** @throws BadInput if it is something else, or too many runs for one campaign */
    static Range of(String text) {
      int dots = text.indexOf("..");
      String expected = "expected A..B with 0 <= A <= B < 2^31";
      try {
        String a = dots < 0 ? text : text.substring(0, dots);
        String b = dots < 0 ? text : text.substring(dots + 2);
        long first = Quantities.whole(a, 0, Integer.MAX_VALUE);
        long last = Quantities.whole(b, 0, Integer.MAX_VALUE);
        if (first <= last && last - first < MOST_RUNS) {
          return new Range(first, last);
        }
        if (first <= last) {
          expected = "expected at most " + MOST_RUNS + " seeds";
        }
      } catch (BadInput noNumbers) {
        throw new BadInput("--seeds: " + BadInput.quote(text) + ": " + expected);
      }
      throw new BadInput("--seeds: " + BadInput.quote(text) + ": " + expected);
    }
  }
}
