package org.starl.robot.create;

import java.util.ArrayList;
import java.util.List;

/** A body on an open floor that feels what a test says, and remembers what its wheels did. */
final class FloorBody implements CreateBody {

  volatile Senses senses = Senses.NOTHING;
  volatile double leftMmPerS;
  volatile double rightMmPerS;

  /** When the wheels last came to a stand. */
  volatile long stoppedNs = -1;

  /** Each change of the wheels: left, right, in whole mm/s. */
  final List<String> driven = new ArrayList<>();

  @Override
  public void drive(double left, double right, long atNs) {
    if (left == leftMmPerS && right == rightMmPerS) {
      return;
    }
    if (left == 0 && right == 0) {
      stoppedNs = atNs;
    }
    leftMmPerS = left;
    rightMmPerS = right;
    driven.add(Math.round(left) + "," + Math.round(right));
  }

  @Override
  public Senses senses(long atNs) {
    return senses;
  }

  boolean stands() {
    return leftMmPerS == 0 && rightMmPerS == 0;
  }
}
