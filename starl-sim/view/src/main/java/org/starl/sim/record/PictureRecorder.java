package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** Takes one picture of a run. */
public final class PictureRecorder implements SimObserver {

  private static final long SECOND_NS = 1_000_000_000;
  private static final long TENTH_NS = SECOND_NS / 10;

  private final Scene scene;
  private final Layer layer;
  private final Page page = new Page();
  private final Moment moment;
  private String name = "";
  private double best;
  private long nextLookNs;
  private @Nullable BufferedImage picture;

  public PictureRecorder(Obstacles obstacles, Layer layer, Moment moment) {
    scene = new Scene(obstacles);
    this.layer = layer;
    this.moment = moment;
  }

  @Override
  public void started(TraceHeader header) {
    name = header.scenario() + ", seed " + header.scenarioSeed();
  }

  @Override
  public void observed(TraceEvent event) {
    switch (moment) {
      case Moment.At at -> {
        if (picture == null && event.timeNs() > at.timeNs()) {
          take(at.timeNs());
        }
      }
      case Moment.Best any -> lookUntil(event.timeNs());
      case Moment.End end -> {
        // Taken when the run has finished.
      }
      case Moment.Violation violation -> {
        // The picture is taken when a violation is reported.
      }
    }
    scene.observe(event);
    layer.observe(event);
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    if (moment instanceof Moment.Violation && picture == null) {
      take(scene.nowNs());
    }
  }

  @Override
  public void finished(SimResult result) {
    if (picture == null && !(moment instanceof Moment.Violation)) {
      take(result.endNs());
    }
  }

  /** The picture; null before it was taken. */
  public @Nullable BufferedImage picture() {
    return picture;
  }

  /** Whether the picture was taken; not if the moment never came. */
  public boolean hasPicture() {
    return picture != null;
  }

  /**
   * Writes the picture as PNG.
   *
   * @throws IllegalStateException if it was not taken
   */
  public void writePng(OutputStream out) throws IOException {
    if (picture == null) {
      throw new IllegalStateException("no picture was taken");
    }
    ImageIO.write(picture, "png", out);
  }

  private void lookUntil(long timeNs) {
    while (nextLookNs < timeNs) {
      scene.advance(nextLookNs);
      double interest = layer.interest(scene);
      if (interest > best) {
        best = interest;
        take(nextLookNs);
      }
      nextLookNs += SECOND_NS;
    }
  }

  private void take(long timeNs) {
    scene.advance(timeNs);
    long tenths = timeNs / TENTH_NS;
    picture = page.paint(scene, layer, name + ", at " + tenths / 10 + "." + tenths % 10 + " s");
  }
}
