package org.starl.apps.intersection.logic;

/** The turns that a car may take, in order of the zones that they need. A U-turn is forbidden. */
public enum Turn {
  RIGHT,
  STRAIGHT,
  LEFT;

  /** Number of critical zones that the car drives through. */
  public int zones() {
    return ordinal() + 1;
  }
}
