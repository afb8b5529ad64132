package org.starl.apps.lightpaint.logic;

/** The states of a painter. */
public enum Location {
  /** Waits until the others know its position; then continues with its note. */
  RESUME,
  /** Chooses a stroke. */
  PICK,
  /** Drives to where its work continues. */
  GO,
  /** Waits until its note of the stroke is on stable storage. */
  NOTE,
  /** Waits until the stroke is assigned. */
  ASK,
  PAINT,
  /** Waits until its note of its progress is on stable storage. */
  LEAVE,
  /** Gives way: goes to its home beside the drawing, and comes back. */
  RETREAT,
  /** Goes home for good. */
  PARK,
  DONE
}
