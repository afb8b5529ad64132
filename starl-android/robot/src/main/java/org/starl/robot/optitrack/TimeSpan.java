package org.starl.robot.optitrack;

/** Something happened between these two times of our clock, ends included. */
record TimeSpan(long earliestNs, long latestNs) {

  long middleNs() {
    return earliestNs + (latestNs - earliestNs) / 2;
  }

  /** It happened within so long of the middle. */
  long boundNs() {
    return (latestNs - earliestNs + 1) / 2;
  }
}
