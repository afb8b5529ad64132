package org.starl.sim.replay;

import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;

/**
 * A position in a recording, and the state of the run at it. It moves forwards by observing the
 * events in between, and backwards by restarting at an earlier checkpoint; it stores checkpoints
 * for itself and other cursors. Used by one thread.
 */
public final class Cursor {

  private final Recording recording;
  private Scene scene;
  private Layer layer;
  private int index;
  private long nowNs;

  /** At the beginning, before the first event. */
  public Cursor(Recording recording) {
    this.recording = recording;
    Checkpoints.Checkpoint first = recording.checkpoints().before(0);
    scene = first.scene().copy();
    layer = first.layer().copy();
  }

  /**
   * Moves to the moment after all events that are not later than {@code timeNs}, limited to the
   * range from the beginning to {@link Recording#endNs}.
   */
  public void seek(long timeNs) {
    long toNs = Math.max(0, Math.min(timeNs, recording.endNs()));
    go(recording.firstAfter(toNs), toNs);
  }

  /**
   * Moves to the moment directly after the event with this index.
   *
   * @throws IndexOutOfBoundsException if there is no such event
   */
  public void toEvent(int number) {
    go(number + 1, recording.timeNs(number));
  }

  /** The current time, in ns from the start of the run. */
  public long nowNs() {
    return nowNs;
  }

  /** The number of events before the cursor, which is the index of the next one. */
  public int index() {
    return index;
  }

  /** The scene at the cursor; valid until the cursor moves. */
  public Scene scene() {
    return scene;
  }

  /** The app's layer at the cursor; valid until the cursor moves. */
  public Layer layer() {
    return layer;
  }

  private void go(int events, long timeNs) {
    boolean isBack = events < index || timeNs < nowNs;
    Checkpoints checkpoints = recording.checkpoints();
    Checkpoints.Checkpoint near = checkpoints.before(events);
    if (isBack || near.events() > index) {
      scene = near.scene().copy();
      layer = near.layer().copy();
      index = near.events();
    }
    while (index < events) {
      var event = recording.event(index);
      scene.observe(event);
      layer.observe(event);
      index++;
      if (checkpoints.isDue(index)) {
        checkpoints.add(index, scene, layer);
      }
    }
    scene.advance(timeNs);
    nowNs = timeNs;
  }
}
