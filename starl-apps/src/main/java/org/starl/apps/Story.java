package org.starl.apps;

import java.util.List;
import org.starl.sim.SimObserver;

/** Observes a run and describes it in a few lines. */
public interface Story extends SimObserver {

  /** The actions of the robots and their times, for users. */
  List<String> lines();

  /** The figures of the run. */
  Measures measures();

  /** Values for charts; the waits unless overridden. */
  default List<Sample> samples() {
    return List.of(Sample.howLong("wait", measures().waitsNs()));
  }

  /** Files that the run produces besides its picture; known before the run. */
  default List<Product> products() {
    return List.of();
  }
}
