package org.starl.sim.replay;

/**
 * A mark on a run's timeline.
 *
 * @param index number of its event, for {@link Cursor#toEvent}
 * @param text one line
 */
public record Mark(long timeNs, int index, Kind kind, String text) {

  /** Kind of a mark. */
  public enum Kind {
    /** A specification is violated. */
    VIOLATION,
    CRASH,
    RESTART,
    /** A fault begins or ends, or all faults have ended. */
    FAULT,
    /** The user injected a fault, sent a point or stopped the run. */
    INTERVENTION
  }
}
