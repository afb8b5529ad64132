package org.starl.sim;

/**
 * What happens to a simulation from outside its robots: bodies come and go, robots join and leave.
 * A director runs in virtual time, as part of the world, and decides by the world and the seed
 * alone.
 */
@FunctionalInterface
public interface Director {

  /** Called once at time 0, after all robots of the start were brought up. */
  void direct(SimControl control);

  /**
   * Whether it brings nobody into the run any more: the run ends when this holds and every app has
   * come to its end. Asked after each event.
   */
  default boolean isOver() {
    return true;
  }
}
