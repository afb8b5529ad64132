package org.starl.sim;

/**
 * Controls a scenario: robots join and leave, bodies come and go. A director runs in virtual time, as
 * part of the world, and decides by the world and the seed alone.
 */
@FunctionalInterface
public interface Director {

  /** Called once at time 0, after the robots that start have started. */
  void direct(SimControl control);

  /**
   * Whether no more robots will join: the run ends when this holds and every app has ended. Asked
   * after each event.
   */
  default boolean isOver() {
    return true;
  }
}
