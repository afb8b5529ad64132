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
import org.starl.geometry.Obstacles;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** Takes a few pictures of a run, at times that are known before: of one that is run again. */
public final class Filmstrip implements SimObserver {

  private static final long TENTH_NS = 100_000_000;

  private final Scene scene;
  private final Layer layer;
  private final Page page = new Page();
  private final List<Long> timesNs;
  private final List<Frame> frames = new ArrayList<>();
  private String name = "";

  /**
   * @param timesNs of the pictures, in ns from the start of the run
   */
  public Filmstrip(Obstacles obstacles, Layer layer, List<Long> timesNs) {
    scene = new Scene(obstacles);
    this.layer = layer;
    this.timesNs = timesNs.stream().sorted().distinct().toList();
  }

  /** One picture, with all that had happened by its time. */
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

    /** Writes it as PNG, legend and all, so many pixels wide. */
    public void writePng(int widthPx, OutputStream out) throws IOException {
      write(image, widthPx, out);
    }

    /** Writes only the floor as PNG, with the given width and height in pixels. */
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
  public void started(TraceHeader header) {
    name = header.scenario() + ", seed " + header.scenarioSeed();
  }

  @Override
  public void observed(TraceEvent event) {
    while (hasNext() && next() < event.timeNs()) {
      take(next());
    }
    scene.observe(event);
    layer.observe(event);
  }

  @Override
  public void finished(SimResult result) {
    while (hasNext() && next() <= result.endNs()) {
      take(next());
    }
  }

  /** Takes the remaining pictures of the current state, after an error has ended the run. */
  public void cut() {
    if (hasNext()) {
      take(Math.min(next(), scene.nowNs()));
    }
  }

  /** The pictures, in order; without those for times that the run did not reach. */
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
    scene.advance(timeNs);
    long tenths = timeNs / TENTH_NS;
    String title = name + ", at " + tenths / 10 + "." + tenths % 10 + " s";
    frames.add(new Frame(timeNs, page.paint(scene, layer, title)));
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
