package org.starl.apps.lightpaint.logic;

/** Where a painter is in its work. */
public enum Location {
  /** Waits until the others know where it stands; then goes on with what its note says. */
  RESUME,
  /** Has nothing in hand, and chooses. */
  PICK,
  /** Drives to where its work goes on. */
  GO,
  /** Writes down what it is about, before it says so. */
  NOTE,
  /** Asks for the stroke. */
  ASK,
  PAINT,
  /** Writes down how far it came. */
  LEAVE,
  /** Gives way: goes to its own place beside the drawing, and comes back. */
  RETREAT,
  /** Goes to its own place for good. */
  PARK,
  DONE
}
