package org.starl.sim.replay;

import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;

/**
 * A place in a recording, and what the run looks like there. It goes forwards by observing the events
 * in between, and backwards by starting again at a checkpoint before; it leaves checkpoints behind for
 * itself and others. One thread's own.
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
   * To the moment after all events that are not later than {@code timeNs}; to the beginning or to {@link
   * Recording#endNs} if that is nearer.
   */
  public void seek(long timeNs) {
    long toNs = Math.max(0, Math.min(timeNs, recording.endNs()));
    go(recording.firstAfter(toNs), toNs);
  }

  /**
   * To the moment right after the event of that number.
   *
   * @throws IndexOutOfBoundsException if the recording has none
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
