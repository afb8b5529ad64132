package org.starl.body;

/** State of the two bump sensors on the robot's front half. */
public enum Bumps {
  NONE,
  LEFT,
  RIGHT,
  BOTH;

  public static Bumps of(boolean left, boolean right) {
    return left ? (right ? BOTH : LEFT) : (right ? RIGHT : NONE);
  }

  public boolean any() {
    return this != NONE;
  }
}
