package org.starl.apps;

import java.util.List;
import java.util.Locale;
import org.starl.sim.SimObserver;
import org.starl.time.Time;

/** Observes a run and tells it in a few lines afterwards. */
public interface Story extends SimObserver {

  /** Who did what and when, for people. */
  List<String> lines();

  /** A time in a story: {@code 12.3 s}. */
  static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", Time.seconds(ns));
  }

  /** The run in numbers. */
  Measures measures();

  /** What the run has many of, for charts: the waits unless an app says more. */
  default List<Sample> samples() {
    return List.of(Sample.howLong("wait", measures().waitsNs()));
  }

  /** Files that the run has to give, beside its picture; known before the run. */
  default List<Product> products() {
    return List.of();
  }
}
