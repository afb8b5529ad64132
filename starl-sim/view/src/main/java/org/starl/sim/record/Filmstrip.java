package org.starl.sim.record;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.sim.SimResult;
import org.starl.spec.SpecReport;

/** Takes pictures of a run at given times. */
public final class Filmstrip extends SceneRecorder {

  private final List<Long> timesNs;
  private final List<Frame> frames = new ArrayList<>();
  private SpecReport.@Nullable Violation marked;

  /**
   * @param timesNs times of the pictures, in ns from the start of the run
   */
  public Filmstrip(Obstacles obstacles, Layer layer, List<Long> timesNs) {
    super(obstacles, layer);
    this.timesNs = timesNs.stream().sorted().distinct().toList();
  }

  /** A picture of the run at one time. */
  public static final class Frame {
    private final long timeNs;
    private final BufferedImage image;

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
      ImageIO.write(scaled(image, widthPx), "png", out);
    }
  }

  @Override
  void takeBefore(long timeNs) {
    while (hasNext() && next() < timeNs) {
      take(next());
    }
  }

  /** Marks the first violation that is as late as a picture; it is told before or after that. */
  @Override
  public void violated(SpecReport.Violation violation) {
    if (marked == null && timesNs.contains(violation.timeNs())) {
      marked = violation;
      if (!frames.isEmpty() && frames.getLast().timeNs == violation.timeNs()) {
        mark(frames.getLast().image, violation);
      }
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
    if (marked != null && marked.timeNs() == timeNs) {
      mark(frame.image, marked);
    }
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
