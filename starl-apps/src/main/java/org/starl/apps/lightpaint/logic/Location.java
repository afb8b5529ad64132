package org.starl.apps.lightpaint.logic;

/** The states of a painter. */
public enum Location {
  /** Waits until the others know its position; then continues with its note. */
  RESUME,
  /** Chooses a stroke. */
  PICK,
  /** Drives to where its work continues, and writes its note. */
  GO,
  /** Waits until the stroke is assigned. */
  ASK,
  /** Claims a tube along its work, paints, and writes its note. */
  PAINT,
  /** Gives way: goes to its home beside the drawing, and comes back. */
  RETREAT,
  /** Goes home for good. */
  PARK,
  DONE
}
