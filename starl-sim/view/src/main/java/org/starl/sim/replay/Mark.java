package org.starl.sim.replay;

/**
 * Something on a run's timeline that people look for.
 *
 * @param index of the event that it is about: {@link Cursor#toEvent} goes there
 * @param text one line
 */
public record Mark(long timeNs, int index, Kind kind, String text) {

  /** The kind of the mark. */
  public enum Kind {
    /** A specification does not hold. */
    VIOLATION,
    CRASH,
    RESTART,
    /** A fault begins or ends, or all have ended. */
    FAULT,
    /** A person did something to the run. */
    INTERVENTION
  }
}
