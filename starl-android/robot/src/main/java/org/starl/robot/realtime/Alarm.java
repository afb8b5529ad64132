package org.starl.robot.realtime;

/** Something that falls due; ordered by time, then by number. Guarded by its strand's lock. */
abstract class Alarm {

  /** The {@code index} of an alarm that is in no heap. */
  static final int NOWHERE = -1;

  long atNs;
  long number;
  int index = NOWHERE;

  /** What to do when it is due, on the strand. */
  abstract void ring() throws Throwable;

  final boolean isBefore(Alarm other) {
    return atNs < other.atNs || (atNs == other.atNs && number < other.number);
  }
}
