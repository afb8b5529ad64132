package org.starl.sim.net;

import java.util.Arrays;
import java.util.List;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.random.Rng;

/**
 * The delay of a datagram: a distribution in ns, never below 0. Its text is what {@link
 * #parse} reads and {@code toString} gives: {@code 100ms}, {@code uniform(10ms,200ms)}, {@code
 * normal(100ms,20ms)}, {@code exponential(50ms)}.
 */
public sealed interface Latency {

  /** Matches every text that {@link #parse} accepts, and some others. */
  String PATTERN =
      "^\\s*(constant|uniform|normal|exponential)\\s*\\([^()]+\\)\\s*$|"
          + Quantity.DURATION.pattern();

  /** Draws a delay, in ns, at least 0. */
  long drawNs(Rng rng);

  /**
   * An upper bound of the delays of a run: the maximum, or a delay that 10^13 draws are not
   * expected to exceed.
   */
  long longestNs();

  /** A lower bound of all delays. */
  default long shortestNs() {
    return 0;
  }

  /** Whether every delay is equal, so that no random number is drawn. */
  default boolean isConstant() {
    return false;
  }

  /** Reads a distribution. @throws BadInput if {@code text} is not one */
  static Latency parse(String text) {
    String stripped = text.strip();
    int open = stripped.indexOf('(');
    if (open < 0) {
      return constantOrError(text, stripped);
    }
    String name = stripped.substring(0, open).strip();
    if (!stripped.endsWith(")")) {
      throw unknown(text);
    }
    List<String> arguments =
        Arrays.asList(stripped.substring(open + 1, stripped.length() - 1).split(",", -1));
    try {
      return switch (name) {
        case "constant" -> new Constant(ns(text, arguments, 1, 0));
        case "uniform" -> new Uniform(ns(text, arguments, 2, 0), ns(text, arguments, 2, 1));
        case "normal" -> new Normal(ns(text, arguments, 2, 0), ns(text, arguments, 2, 1));
        case "exponential" -> new Exponential(ns(text, arguments, 1, 0));
        default -> throw unknown(text);
      };
    } catch (IllegalArgumentException outOfRange) {
      throw new BadInput(BadInput.quote(text) + ": " + outOfRange.getMessage());
    }
  }

  private static Latency constantOrError(String text, String stripped) {
    boolean looksLikeANumber =
        !stripped.isEmpty() && "+-.0123456789".indexOf(stripped.charAt(0)) >= 0;
    if (!looksLikeANumber) {
      throw unknown(text);
    }
    return new Constant(Quantities.durationNs(stripped));
  }

  private static long ns(String text, List<String> arguments, int expected, int index) {
    if (arguments.size() != expected) {
      throw unknown(text);
    }
    try {
      return Quantities.durationNs(arguments.get(index));
    } catch (BadInput notADuration) {
      throw Quantities.in(BadInput.quote(text), notADuration);
    }
  }

  private static BadInput unknown(String text) {
    return new BadInput(
        BadInput.quote(text)
            + ": expected a delay, 100ms, or uniform(10ms,200ms), normal(100ms,20ms),"
            + " exponential(50ms)");
  }

  /** Always {@code ns}. */
  record Constant(long ns) implements Latency {
    public Constant {
      require(ns >= 0, "expected a delay of at least 0");
    }

    @Override
    public long drawNs(Rng rng) {
      return ns;
    }

    @Override
    public long longestNs() {
      return ns;
    }

    @Override
    public long shortestNs() {
      return ns;
    }

    @Override
    public boolean isConstant() {
      return true;
    }

    @Override
    public String toString() {
      return Quantities.durationText(ns);
    }
  }

  /** Each ns from {@code minNs} to {@code maxNs}, both included, with equal probability. */
  record Uniform(long minNs, long maxNs) implements Latency {
    public Uniform {
      require(minNs >= 0 && minNs <= maxNs, "expected uniform(least,most) with 0 <= least <= most");
    }

    @Override
    public long drawNs(Rng rng) {
      return rng.nextLong(minNs, maxNs);
    }

    @Override
    public long longestNs() {
      return maxNs;
    }

    @Override
    public long shortestNs() {
      return minNs;
    }

    @Override
    public String toString() {
      return call("uniform", minNs, maxNs);
    }
  }

  /**
   * Normal with this mean and deviation, truncated: a negative value is drawn again, so that the
   * true mean is slightly above {@code meanNs} unless the deviation is small compared with it.
   */
  record Normal(long meanNs, long deviationNs) implements Latency {
    public Normal {
      require(meanNs >= 0 && deviationNs >= 0, "expected normal(mean,deviation), both at least 0");
    }

    @Override
    public long drawNs(Rng rng) {
      double ns;
      do {
        ns = meanNs + deviationNs * rng.nextGaussian();
      } while (ns < 0);
      return Math.round(ns);
    }

    @Override
    public long longestNs() {
      return meanNs + 8 * deviationNs;
    }

    @Override
    public String toString() {
      return call("normal", meanNs, deviationNs);
    }
  }

  /** Exponential with this mean: most datagrams are fast, a few very late. */
  record Exponential(long meanNs) implements Latency {
    public Exponential {
      require(meanNs >= 0, "expected exponential(mean) with a mean of at least 0");
    }

    @Override
    public long drawNs(Rng rng) {
      return Math.round(meanNs * rng.nextExponential());
    }

    @Override
    public long longestNs() {
      return 30 * meanNs;
    }

    @Override
    public String toString() {
      return "exponential(" + Quantities.durationText(meanNs) + ")";
    }
  }

  private static String call(String name, long first, long second) {
    return "%s(%s,%s)"
        .formatted(name, Quantities.durationText(first), Quantities.durationText(second));
  }

  private static void require(boolean holds, String message) {
    if (!holds) {
      throw new IllegalArgumentException(message);
    }
  }
}
