package org.starl.cli.report;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * A chart axis from 0 to {@code steps} times {@code step}, with a tick at each step.
 *
 * @param label the quantity, with its unit
 * @param step 1, 2 or 5 times a power of 10
 */
record Axis(String label, double step, int steps) {

  /**
   * An axis that covers 0 to {@code most}.
   *
   * @param fewest approximate number of steps
   * @param isWhole whether steps are at least 1, because the values are counts
   */
  static Axis upTo(String label, double most, int fewest, boolean isWhole) {
    double step = most > 0 ? nice(most / fewest) : 1;
    if (isWhole) {
      step = Math.max(1, step);
    }
    // A rounding error of the division must not add a step.
    int steps = (int) Math.max(1, Math.ceil(most / step - 1e-9));
    return new Axis(label, step, steps);
  }

  /** The smallest 1, 2 or 5 times a power of 10 that is not below {@code value}. */
  static double nice(double value) {
    int power = (int) Math.floor(StrictMath.log10(value));
    return IntStream.of(1, 2, 5, 10)
        .mapToDouble(factor -> BigDecimal.valueOf(factor, -power).doubleValue())
        .filter(step -> step >= value)
        .findFirst()
        .orElseThrow();
  }

  double max() {
    return step * steps;
  }

  List<Double> ticks() {
    List<Double> ticks = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      ticks.add(i * step);
    }
    return ticks;
  }

  /** A value with as many decimals as the ticks need. */
  String text(double value) {
    int digits = 0;
    for (double s = step; s < 0.999 && digits < 6; s *= 10) {
      digits++;
    }
    return digits == 0
        ? NumberFormats.count(Math.round(value))
        : String.format(Locale.ROOT, "%." + digits + "f", value);
  }
}
