package org.starl.robot.realtime;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A binary heap of alarms, each of which knows its index, so that any one can be taken out. */
final class AlarmHeap {

  private final List<Alarm> alarms = new ArrayList<>();
  private long lastNumber;

  /** The alarm that is due first, or null. */
  @Nullable Alarm first() {
    return alarms.isEmpty() ? null : alarms.get(0);
  }

  /** Adds an alarm that is in no heap; among those of equal time it comes last. */
  void add(Alarm alarm, long atNs) {
    alarm.atNs = atNs;
    alarm.number = ++lastNumber;
    alarms.add(alarm);
    siftUp(alarms.size() - 1, alarm);
  }

  /** Takes an alarm out, if it is in. */
  void remove(Alarm alarm) {
    int index = alarm.index;
    if (index == Alarm.NOWHERE) {
      return;
    }
    alarm.index = Alarm.NOWHERE;
    Alarm last = alarms.remove(alarms.size() - 1);
    if (last == alarm) {
      return;
    }
    if (index > 0 && last.isBefore(alarms.get((index - 1) / 2))) {
      siftUp(index, last);
    } else {
      siftDown(index, last);
    }
  }

  void clear() {
    for (Alarm alarm : alarms) {
      alarm.index = Alarm.NOWHERE;
    }
    alarms.clear();
  }

  private void siftUp(int from, Alarm alarm) {
    int index = from;
    while (index > 0 && alarm.isBefore(alarms.get((index - 1) / 2))) {
      put(index, alarms.get((index - 1) / 2));
      index = (index - 1) / 2;
    }
    put(index, alarm);
  }

  private void siftDown(int from, Alarm alarm) {
    int index = from;
    for (int child = 2 * index + 1; child < alarms.size(); child = 2 * index + 1) {
      if (child + 1 < alarms.size() && alarms.get(child + 1).isBefore(alarms.get(child))) {
        child++;
      }
      if (!alarms.get(child).isBefore(alarm)) {
        break;
      }
      put(index, alarms.get(child));
      index = child;
    }
    put(index, alarm);
  }

  private void put(int index, Alarm alarm) {
    alarms.set(index, alarm);
    alarm.index = index;
  }
}
