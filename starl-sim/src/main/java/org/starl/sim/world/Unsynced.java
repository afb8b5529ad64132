package org.starl.sim.world;

/**
 * What a crash does to writes to stable storage that were not flushed. Flushes keep the order of the
 * writes, so what survives of them is always the earliest.
 */
public enum Unsynced {
  /** None survives. */
  LOST,
  /** As many survive as are drawn, from none to all. */
  SOME,
  /** All survive. */
  KEPT
}
