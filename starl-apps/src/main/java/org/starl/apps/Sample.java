package org.starl.apps;

import java.util.List;
import org.starl.time.Time;

/**
 * Values of one run for a chart of a campaign's report. The chart shows the samples of one name of
 * all runs, so an app uses the same names in every run.
 *
 * @param name in the report, such as {@code wait for the zones}; for times that of the event, such
 *     as {@code crossings}
 * @param unit of the values at the axis: {@code s}
 * @param values each finite and not below 0, in any order
 */
public record Sample(String name, Kind kind, String unit, List<Double> values) {

  /** The kind of chart. */
  public enum Kind {
    /** The chart shows the distribution. */
    SIZES,
    /** Times from the start of the run; the chart shows the number of events over time. */
    TIMES
  }

  public Sample {
    for (double value : values) {
      if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException("sample '" + name + "' has " + value);
      }
    }
    values = List.copyOf(values);
  }

  /** Durations. */
  public static Sample howLong(String name, List<Long> valuesNs) {
    return new Sample(name, Kind.SIZES, "s", seconds(valuesNs));
  }

  /** Times of events. */
  public static Sample when(String name, List<Long> timesNs) {
    return new Sample(name, Kind.TIMES, "s", seconds(timesNs));
  }

  private static List<Double> seconds(List<Long> valuesNs) {
    return valuesNs.stream().map(Time::seconds).toList();
  }
}
