package org.starl.sim.world;

/**
 * The effect of a crash on unflushed writes to stable storage. Flushes keep the order of the
 * writes, so the surviving writes are always the earliest.
 */
public enum Unsynced {
  /** No unflushed write survives. */
  LOST,
  /** A random number of unflushed writes survives, from none to all. */
  SOME,
  /** All unflushed writes survive. */
  KEPT
}
