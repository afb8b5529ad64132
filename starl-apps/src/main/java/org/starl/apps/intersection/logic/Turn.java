package org.starl.apps.intersection.logic;

/** What a car does at the intersection. A U-turn is forbidden. */
public enum Turn {
  RIGHT(1),
  STRAIGHT(2),
  LEFT(3);

  private final int zones;

  Turn(int zones) {
    this.zones = zones;
  }

  /** How many critical zones the car drives through. */
  public int zones() {
    return zones;
  }
}
