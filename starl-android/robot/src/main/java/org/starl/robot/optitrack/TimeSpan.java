package org.starl.robot.optitrack;

/** An interval of our clock that contains the time of an event, ends included. */
record TimeSpan(long earliestNs, long latestNs) {

  long middleNs() {
    return earliestNs + (latestNs - earliestNs) / 2;
  }

  /** Half its length. */
  long boundNs() {
    return (latestNs - earliestNs + 1) / 2;
  }
}
