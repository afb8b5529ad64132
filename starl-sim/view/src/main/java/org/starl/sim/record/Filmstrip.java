package org.starl.sim.record;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.geometry.Obstacles;
import org.starl.sim.Failure;
import org.starl.sim.SimResult;

/** Takes pictures of a run at given times. */
public final class Filmstrip extends SceneRecorder {

  private final List<Long> timesNs;
  private final List<Frame> frames = new ArrayList<>();
  // What the last picture shows: what went wrong then may be told later.
  private Scene lastScene;
  private Layer lastLayer;

  /**
   * @param timesNs times of the pictures, in ns from the start of the run
   */
  public Filmstrip(Obstacles obstacles, Layer layer, List<Long> timesNs) {
    super(obstacles, layer);
    this.timesNs = timesNs.stream().sorted().distinct().toList();
    lastScene = scene;
    lastLayer = layer;
  }

  /** A picture of the run at one time. */
  public static final class Frame {
    private final long timeNs;
    private BufferedImage image;

    private Frame(long timeNs, BufferedImage image) {
      this.timeNs = timeNs;
      this.image = image;
    }

    public long timeNs() {
      return timeNs;
    }

    /** Writes floor and legend as PNG, {@code widthPx} wide. */
    public void writePng(int widthPx, OutputStream out) throws IOException {
      write(image, widthPx, out);
    }

    /** Writes the floor without the legend as PNG, {@code widthPx} wide and high. */
    public void writeFloorPng(int widthPx, OutputStream out) throws IOException {
      int sidePx = Math.min(image.getWidth(), image.getHeight());
      write(image.getSubimage(0, 0, sidePx, sidePx), widthPx, out);
    }

    private static void write(BufferedImage image, int widthPx, OutputStream out)
        throws IOException {
      Png.write(scaled(image, widthPx), out);
    }
  }

  @Override
  void takeBefore(long timeNs) {
    while (hasNext() && next() < timeNs) {
      take(next());
    }
  }

  @Override
  public void wentWrong(Failure failure) {
    super.wentWrong(failure);
    if (!frames.isEmpty() && frames.getLast().timeNs == failure.atNs()) {
      lastScene.describe(failure);
      frames.getLast().image = paint(lastScene, lastLayer);
    }
  }

  @Override
  public void finished(SimResult result) {
    takeBefore(result.endNs() + 1);
  }

  /** Takes the next picture now, if one is left: for a run that an error ended. */
  public void cut() {
    if (hasNext()) {
      take(Math.min(next(), scene.nowNs()));
    }
  }

  /** The pictures in order, without those for times after the end of the run. */
  public List<Frame> frames() {
    return Collections.unmodifiableList(frames);
  }

  private boolean hasNext() {
    return frames.size() < timesNs.size();
  }

  private long next() {
    return timesNs.get(frames.size());
  }

  private void take(long timeNs) {
    Frame frame = new Frame(timeNs, paint(timeNs));
    lastScene = scene.copy();
    lastLayer = layer.copy();
    frames.add(frame);
  }

  static BufferedImage scaled(BufferedImage image, int widthPx) {
    int heightPx = image.getHeight() * widthPx / image.getWidth();
    BufferedImage small = new BufferedImage(widthPx, heightPx, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = small.createGraphics();
    page.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
    page.setRenderingHint(RenderingHints.KEY_RENDERING, RenderingHints.VALUE_RENDER_QUALITY);
    page.drawImage(image, 0, 0, widthPx, heightPx, null);
    page.dispose();
    return small;
  }
}
