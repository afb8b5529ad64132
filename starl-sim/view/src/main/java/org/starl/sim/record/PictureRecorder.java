package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.sim.Failure;
import org.starl.sim.SimResult;
import org.starl.time.Time;

/** Takes one picture of a run. */
public final class PictureRecorder extends SceneRecorder {

  private final PictureTime moment;
  private double best;
  private long nextLookNs;
  private @Nullable BufferedImage picture;

  /** What to paint when the picture is written: painting is slow, and a better moment may come. */
  private @Nullable Scene bestScene;

  private Layer bestLayer = Layer.NONE;

  public PictureRecorder(Obstacles obstacles, Layer layer, PictureTime moment) {
    super(obstacles, layer);
    this.moment = moment;
  }

  @Override
  void takeBefore(long timeNs) {
    switch (moment) {
      case PictureTime.At at -> {
        if (picture == null && timeNs > at.timeNs()) {
          picture = paint(at.timeNs());
        }
      }
      case PictureTime.Best any -> takeBest(timeNs);
      case PictureTime.End end -> {
        // See finished().
      }
      case PictureTime.Violation violation -> {
        // See violated().
      }
    }
  }

  private void takeBest(long timeNs) {
    while (picture == null && nextLookNs < timeNs) {
      scene.advance(nextLookNs);
      double interest = layer.interest(scene);
      if (interest > best) {
        best = interest;
        bestScene = scene.copy();
        bestLayer = layer.copy();
      }
      nextLookNs += Time.NS_PER_S;
    }
  }

  @Override
  public void wentWrong(Failure failure) {
    super.wentWrong(failure);
    boolean isViolation = failure.kind() == Failure.Kind.VIOLATED;
    boolean isEnd = failure.kind() == Failure.Kind.FAILED && picture == null;
    if (moment instanceof PictureTime.Best
        || (moment instanceof PictureTime.Violation ? isViolation : isEnd)) {
      picture = paint(Math.max(scene.nowNs(), failure.atNs()));
    }
  }

  @Override
  public void finished(SimResult result) {
    if (!hasPicture() && !(moment instanceof PictureTime.Violation)) {
      picture = paint(result.endNs());
    }
  }

  /** Whether the moment came and the picture was taken. */
  public boolean hasPicture() {
    return picture != null || bestScene != null;
  }

  /**
   * Writes the picture as PNG.
   *
   * @throws IllegalStateException if there is no picture
   */
  public void writePng(OutputStream out) throws IOException {
    if (layer == Layer.NONE && scene.isStill()) {
      bestScene = scene; // its lanes are longest at the end
    }
    BufferedImage image =
        picture != null || bestScene == null ? picture : paint(bestScene, bestLayer);
    if (image == null) {
      throw new IllegalStateException("no picture was taken");
    }
    Png.write(image, out);
  }
}
