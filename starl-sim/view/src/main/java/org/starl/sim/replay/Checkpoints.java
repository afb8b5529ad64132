package org.starl.sim.replay;

import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;

/**
 * States of a recording after some of its events, so that a {@link Cursor} can go back without
 * starting at the beginning. Cursors add them every {@code stride} events; when there are too many,
 * every other one is removed and the stride doubles. Thread-safe.
 */
final class Checkpoints {

  /** The state after some events; copy scene and layer before use. */
  record Checkpoint(int events, Scene scene, Layer layer) {}

  private static final int FIRST_STRIDE = 1 << 8;
  private static final int MOST = 96;
  private static final int LEAST = 2;

  /** Least distance of two checkpoints, in events for each robot. */
  private static final int EVENTS_A_ROBOT = 8;

  private static final long MOST_BYTES = Math.min(1 << 30, Runtime.getRuntime().maxMemory() / 5);

  // A robot without its trail: pose, variables, and its part of the layer.
  private static final int ROBOT_BYTES = 1000;
  private static final int POINT_BYTES = 16;

  private final long mostBytes;
  private final TreeMap<Integer, Checkpoint> byEvents = new TreeMap<>();
  private volatile int stride = FIRST_STRIDE;

  /** Begins with the state before the first event. */
  Checkpoints(Scene scene, Layer layer) {
    this(scene, layer, MOST_BYTES);
  }

  /**
   * Begins with the state before the first event.
   *
   * @param mostBytes approximate limit for the memory of all checkpoints
   */
  Checkpoints(Scene scene, Layer layer, long mostBytes) {
    this.mostBytes = mostBytes;
    byEvents.put(0, new Checkpoint(0, scene, layer));
  }

  /** Whether {@link #add} wants a checkpoint after {@code events} events. */
  boolean isDue(int events) {
    return events % stride == 0;
  }

  /** Keeps copies of scene and layer, unless there is a checkpoint already. */
  synchronized void add(int events, Scene scene, Layer layer) {
    if (events % stride != 0 || byEvents.containsKey(events)) {
      return;
    }
    int robots = scene.robots().size();
    if (stride < EVENTS_A_ROBOT * robots) {
      // Copying so many robots takes longer than observing the events again.
      widen();
      return;
    }
    byEvents.put(events, new Checkpoint(events, scene.copy(), layer.copy()));
    long most = Math.max(LEAST, Math.min(MOST, mostBytes / Math.max(1, bytes(scene))));
    while (byEvents.size() > most) {
      widen();
    }
  }

  /** Memory that a copy needs, unless it still shares trails with another one. */
  private static long bytes(Scene scene) {
    long bytes = 0;
    for (RobotId robot : scene.robots()) {
      bytes += ROBOT_BYTES + (long) POINT_BYTES * scene.trail(robot).size();
    }
    return bytes;
  }

  private void widen() {
    int wider = 2 * stride;
    byEvents.keySet().removeIf(each -> each % wider != 0);
    stride = wider;
  }

  /** The last checkpoint after at most {@code events} events. */
  synchronized Checkpoint before(int events) {
    return byEvents.floorEntry(events).getValue();
  }

  synchronized int size() {
    return byEvents.size();
  }
}
