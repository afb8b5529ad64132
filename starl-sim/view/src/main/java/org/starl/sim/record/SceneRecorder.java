package org.starl.sim.record;

import java.awt.image.BufferedImage;
import org.starl.geometry.Obstacles;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** Keeps the scene of a run up to date, and paints it for a file. */
abstract sealed class SceneRecorder implements SimObserver
    permits AnimationRecorder, Filmstrip, PictureRecorder {

  private static final long TENTH_NS = 100_000_000;

  final Scene scene;
  final Layer layer;
  private final Lanes lanes = new Lanes();
  private final Page page = new Page();
  private String name = "";

  SceneRecorder(Obstacles obstacles, Layer layer) {
    scene = new Scene(obstacles);
    this.layer = layer;
  }

  /** Takes the pictures that are due before an event at {@code timeNs}. */
  abstract void takeBefore(long timeNs);

  @Override
  public final void started(TraceHeader header) {
    name = header.scenario() + ", seed " + header.scenarioSeed();
  }

  @Override
  public final void observed(TraceEvent event) {
    takeBefore(event.timeNs());
    scene.observe(event);
    lanes.observe(event);
    layer.observe(event);
  }

  /** The picture at {@code timeNs}, which is not before the last observed event. */
  final BufferedImage paint(long timeNs) {
    scene.advance(timeNs);
    return paint(scene, layer);
  }

  final BufferedImage paint(Scene shown, Layer shownLayer) {
    long tenths = shown.nowNs() / TENTH_NS;
    return page.paint(
        shown, shownLayer, lanes, name + ", at " + tenths / 10 + "." + tenths % 10 + " s");
  }

  /** From now on, pictures show what went wrong; subclasses call it before they take one of it. */
  @Override
  public void wentWrong(Failure failure) {
    scene.describe(failure);
  }
}
