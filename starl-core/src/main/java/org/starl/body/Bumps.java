package org.starl.body;

/** The two bump sensors on a robot's front half. */
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
