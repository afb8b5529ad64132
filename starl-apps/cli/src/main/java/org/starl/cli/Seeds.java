package org.starl.cli;

import java.security.SecureRandom;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses seeds. */
final class Seeds {

  private static final int DRAWN_BELOW = 1_000_000;

  private Seeds() {}

  /** The seed in {@code text}; if it is null, a random seed that is short enough to type. */
  static long of(@Nullable String text) {
    if (text == null) {
      return new SecureRandom().nextInt(DRAWN_BELOW);
    }
    return Numbers.whole("--seed", text, Long.MIN_VALUE, Long.MAX_VALUE);
  }

  /** {@code A..B}. */
  record Range(long first, long last) {

    private static final int MAX_RUNS = 10_000_000;

    /**
     * @throws BadInput unless it is {@code A..B} with at most 10000000 seeds
     */
    static Range of(String text) {
      int dots = text.indexOf("..");
      String expected = "expected A..B with 0 <= A <= B < 2^31";
      try {
        String a = dots < 0 ? text : text.substring(0, dots);
        String b = dots < 0 ? text : text.substring(dots + 2);
        long first = Quantities.whole(a, 0, Integer.MAX_VALUE);
        long last = Quantities.whole(b, 0, Integer.MAX_VALUE);
        if (first <= last && last - first < MAX_RUNS) {
          return new Range(first, last);
        }
        if (first <= last) {
          expected = "expected at most " + MAX_RUNS + " seeds";
        }
      } catch (BadInput noNumbers) {
        throw new BadInput("--seeds: " + BadInput.quote(text) + ": " + expected);
      }
      throw new BadInput("--seeds: " + BadInput.quote(text) + ": " + expected);
    }
  }
}
