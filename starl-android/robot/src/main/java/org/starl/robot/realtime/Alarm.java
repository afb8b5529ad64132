package org.starl.robot.realtime;

/** An action with a due time; ordered by time, then by number. Guarded by its strand's lock. */
abstract class Alarm implements Comparable<Alarm> {

  // Both constant while the alarm is set.
  long atNs;
  long number;

  /** The action, on the strand. */
  abstract void ring() throws Throwable;

  @Override
  public final int compareTo(Alarm other) {
    int byTime = Long.compare(atNs, other.atNs);
    return byTime != 0 ? byTime : Long.compare(number, other.number);
  }
}
