package org.starl.sim.replay;

import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;

/**
 * A position in a recording, and the state of the run there. A cursor goes forwards by observing
 * the events in between, and backwards by observing events from an earlier checkpoint on. It adds
 * checkpoints to the recording, and keeps one of its own near its position. Not thread-safe.
 */
public final class Cursor {

  /** Distance of the own checkpoint after a long way, in events. */
  private static final int NEAR = 1 << 14;

  private final Recording recording;
  private Checkpoints.Checkpoint own;
  private Scene scene;
  private Layer layer;
  private int index;
  private long nowNs;

  /** Starts before the first event. */
  public Cursor(Recording recording) {
    this.recording = recording;
    own = recording.checkpoints().before(0);
    scene = own.scene().copy();
    layer = own.layer().copy();
  }

  /**
   * Goes to {@code timeNs}, after all events of that time; at least to 0 and at most to {@link
   * Recording#endNs}.
   */
  public void seek(long timeNs) {
    long toNs = Math.max(0, Math.min(timeNs, recording.endNs()));
    go(recording.firstAfter(toNs), toNs);
  }

  /**
   * Goes to the moment right after event {@code number}.
   *
   * @throws IndexOutOfBoundsException if the recording has none
   */
  public void toEvent(int number) {
    go(number + 1, recording.timeNs(number));
  }

  /** The time of the position, in ns from the start of the run. */
  public long nowNs() {
    return nowNs;
  }

  /** Number of events before the position. */
  public int index() {
    return index;
  }

  /** The scene; valid until the cursor moves. */
  public Scene scene() {
    return scene;
  }

  /** The app's layer; valid until the cursor moves. */
  public Layer layer() {
    return layer;
  }

  private void go(int events, long timeNs) {
    boolean isBack = events < index || timeNs < nowNs;
    Checkpoints checkpoints = recording.checkpoints();
    Checkpoints.Checkpoint near = checkpoints.before(events);
    if (own.events() <= events && own.events() > near.events()) {
      near = own;
    }
    if (isBack || near.events() > index) {
      scene = near.scene().copy();
      layer = near.layer().copy();
      index = near.events();
    }
    int keptAt = index < events - 2 * NEAR ? events - NEAR : -1;
    while (index < events) {
      var event = recording.event(index);
      scene.observe(event);
      layer.observe(event);
      index++;
      if (checkpoints.isDue(index)) {
        checkpoints.add(index, scene, layer);
      }
      if (index == keptAt) {
        own = new Checkpoints.Checkpoint(index, scene.copy(), layer.copy());
      }
    }
    scene.advance(timeNs);
    scene.describe(recording.wentWrong());
    nowNs = timeNs;
  }
}
