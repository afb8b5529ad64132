package org.starl.sim.replay;

import java.util.TreeMap;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;

/**
 * Copies of the scene after some events of a recording, stored by cursors that pass there, so that
 * later cursors need not start from the beginning. They have a minimum distance in events; when
 * there are too many, every other one is removed. Thread-safe.
 */
final class Checkpoints {

  /** A moment, never changed: to go on from it, copy it. */
  record Checkpoint(int events, Scene scene, Layer layer) {}

  private static final int FIRST_STRIDE = 1 << 8;
  private static final int MOST = 96;
  private static final int LEAST = 8;

  /** The minimum number of events between checkpoints, per robot. */
  private static final int EVENTS_A_ROBOT = 8;

  /** A scene of many robots is large. */
  private static final int MOST_ROBOTS = 200_000;

  private final TreeMap<Integer, Checkpoint> byEvents = new TreeMap<>();
  private volatile int stride = FIRST_STRIDE;

  /** Begins with the moment before the first event. */
  Checkpoints(Scene scene, Layer layer) {
    byEvents.put(0, new Checkpoint(0, scene, layer));
  }

  /** Whether {@link #add} is of use after so many events. */
  boolean isDue(int events) {
    return events % stride == 0;
  }

  /** Keeps copies of the two, which stand right after an event, if there are none. */
  synchronized void add(int events, Scene scene, Layer layer) {
    if (events % stride != 0 || byEvents.containsKey(events)) {
      return;
    }
    int robots = scene.robots().size();
    if (stride < EVENTS_A_ROBOT * robots) {
      // To copy so many would take longer than to go through the events again.
      widen();
      return;
    }
    byEvents.put(events, new Checkpoint(events, scene.copy(), layer.copy()));
    int most = Math.max(LEAST, Math.min(MOST, MOST_ROBOTS / Math.max(1, robots)));
    while (byEvents.size() > most) {
      widen();
    }
  }

  private void widen() {
    int wider = 2 * stride;
    byEvents.keySet().removeIf(each -> each % wider != 0);
    stride = wider;
  }

  /** The last one after at most so many events. */
  synchronized Checkpoint before(int events) {
    return byEvents.floorEntry(events).getValue();
  }

  synchronized int size() {
    return byEvents.size();
  }
}
