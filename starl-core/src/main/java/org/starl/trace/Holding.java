package org.starl.trace;

/** A fact after which its instance holds or waits for something else than before. */
public interface Holding {

  /** What it holds or waits for from now on, for people: {@code holds [A]}; empty for nothing. */
  String holding();
}
