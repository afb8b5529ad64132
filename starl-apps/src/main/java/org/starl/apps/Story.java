package org.starl.apps;

import java.util.List;
import org.starl.sim.SimObserver;

/** Observes a run and tells it in a few lines afterwards. */
public interface Story extends SimObserver {

  /** Who did what and when, for people. */
  List<String> lines();

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
