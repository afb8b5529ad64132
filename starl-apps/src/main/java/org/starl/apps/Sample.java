package org.starl.apps;

import java.util.ArrayList;
import java.util.List;

/**
 * Something that a run has many of, for the charts of a campaign's report: the runs' samples of one
 * name are put together, so an app names the same ones in every run.
 *
 * @param name for people: {@code wait for the zones}; of times, what happened: {@code crossings}
 * @param kind how it is to be drawn
 * @param unit of the values, as on an axis: {@code s}
 * @param values each finite and not below 0, in any order
 */
public record Sample(String name, Kind kind, String unit, List<Double> values) {

  private static final double NS_PER_S = 1e9;

  /** What the values are. */
  public enum Kind {
    /** Sizes: how they are spread is of interest. */
    SIZES,
    /** Times from the start of the run: how many there were by when is of interest. */
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

  /** How long something took, each time. */
  public static Sample howLong(String name, List<Long> valuesNs) {
    return new Sample(name, Kind.SIZES, "s", seconds(valuesNs));
  }

  /** When something happened, each time. */
  public static Sample when(String name, List<Long> timesNs) {
    return new Sample(name, Kind.TIMES, "s", seconds(timesNs));
  }

  private static List<Double> seconds(List<Long> valuesNs) {
    List<Double> seconds = new ArrayList<>(valuesNs.size());
    for (long valueNs : valuesNs) {
      seconds.add(valueNs / NS_PER_S);
    }
    return seconds;
  }
}
