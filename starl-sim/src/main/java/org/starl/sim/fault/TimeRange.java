package org.starl.sim.fault;

import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.random.Rng;

/**
 * A time or a time span in ns, drawn evenly from the least to the most: {@code 5s}, {@code 5s..20s}.
 */
public record TimeRange(long leastNs, long mostNs) {

  static final TimeRange ZERO = exactly(0);

  public TimeRange {
    if (leastNs < 0 || mostNs < leastNs) {
      throw new IllegalArgumentException(
          leastNs + ".." + mostNs + " ns: expected at least 0, the smaller one first");
    }
  }

  public static TimeRange exactly(long ns) {
    return new TimeRange(ns, ns);
  }

  /** @throws BadInput if {@code text} is not {@code 5s} or {@code 5s..20s} */
  public static TimeRange parse(String text) {
    int dots = text.indexOf("..");
    if (dots < 0) {
      return exactly(Quantities.durationNs(text));
    }
    long leastNs = Quantities.durationNs(text.substring(0, dots));
    long mostNs = Quantities.durationNs(text.substring(dots + 2));
    if (mostNs < leastNs) {
      throw new BadInput(BadInput.quote(text) + ": expected the earlier time first");
    }
    return new TimeRange(leastNs, mostNs);
  }

  long drawNs(Rng rng) {
    return leastNs == mostNs ? leastNs : rng.nextLong(leastNs, mostNs);
  }

  @Override
  public String toString() {
    String least = Quantities.durationText(leastNs);
    return leastNs == mostNs ? least : least + ".." + Quantities.durationText(mostNs);
  }
}
