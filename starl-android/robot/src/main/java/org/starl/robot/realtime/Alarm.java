package org.starl.robot.realtime;

/** An action with a due time; ordered by time, then by number. Guarded by its strand's lock. */
abstract class Alarm {

  /** The {@code index} of an alarm that is in no heap. */
  static final int NOWHERE = -1;

  long atNs;
  long number;
  int index = NOWHERE;

  /** The action, on the strand. */
  abstract void ring() throws Throwable;

  final boolean isBefore(Alarm other) {
    return atNs < other.atNs || (atNs == other.atNs && number < other.number);
  }
}
