package org.starl.sim;

/**
 * Controls a scenario: adds and removes robots and bodies. A director runs in virtual time, as part
 * of the world; its decisions depend only on the world and the seed.
 */
@FunctionalInterface
public interface Director {

  /** Called once at time 0, after the initial robots have started. */
  void direct(SimControl control);

  /**
   * Whether no more robots will join. The run ends when this holds and every app has ended.
   * Evaluated after each event.
   */
  default boolean isOver() {
    return true;
  }
}
