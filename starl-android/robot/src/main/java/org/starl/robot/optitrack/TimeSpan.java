package org.starl.robot.optitrack;

/** An interval of our clock in which something happened, ends included. */
record TimeSpan(long earliestNs, long latestNs) {

  long middleNs() {
    return earliestNs + (latestNs - earliestNs) / 2;
  }

  /** Half its length. */
  long boundNs() {
    return (latestNs - earliestNs + 1) / 2;
  }
}
