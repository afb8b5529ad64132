package org.starl.cli.request;

import java.security.SecureRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.OptionValues;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses seeds. */
public final class Seeds {

  private static final int DRAWN_BELOW = 1_000_000;

  private Seeds() {}

  /** The seed in {@code text}; if it is null, a random seed that is short enough to type. */
  public static long of(@Nullable String text) {
    return text == null
        ? new SecureRandom().nextInt(DRAWN_BELOW)
        : OptionValues.read(
            "--seed", text, seed -> Quantities.whole(seed, Long.MIN_VALUE, Long.MAX_VALUE));
  }

  /** {@code A..B}: seeds, or other numbers of runs. */
  public record Range(long first, long last) {

    private static final int MAX_RUNS = 10_000_000;
    private static final Pattern TEXT = Pattern.compile("(\\d{1,10})(?:\\.\\.(\\d{1,10}))?");

    /**
     * @throws BadInput unless it is {@code A..B} or {@code A}, with at most 10000000 seeds
     */
    public static Range of(String text) {
      Matcher matcher = TEXT.matcher(text.strip());
      if (matcher.matches()) {
        long first = Long.parseLong(matcher.group(1));
        long last = matcher.group(2) == null ? first : Long.parseLong(matcher.group(2));
        if (first <= last && last <= Integer.MAX_VALUE && last - first < MAX_RUNS) {
          return new Range(first, last);
        }
      }
      throw new BadInput(
          "--seeds: %s: expected A..B or A, with 0 <= A <= B < 2^31 and at most %d seeds"
              .formatted(BadInput.quote(text), MAX_RUNS));
    }

    /** The number of seeds. */
    public long size() {
      return last - first + 1;
    }

    public boolean has(long seed) {
      return first <= seed && seed <= last;
    }

    @Override
    public String toString() {
      return first + ".." + last;
    }
  }
}
