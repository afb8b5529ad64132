package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.starl.geometry.Obstacles;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Records an animation of a run, with the painter of the still pictures: frames at a fixed interval
 * of virtual time. For a violation it keeps the frames before it.
 */
public final class GifRecorder implements SimObserver {

  private static final long NS_PER_S = 1_000_000_000;
  private static final long TENTH_NS = NS_PER_S / 10;
  private static final String FORMAT = "javax_imageio_gif_image_1.0";

  /** Hundredths of a second between two frames as they are shown. */
  private static final int SHOWN_CS = 5;

  /** Before and after a violation. */
  private static final int FRAMES_BEFORE = 60;

  private static final int FRAMES_AFTER = 20;

  private final Scene scene;
  private final Layer layer;
  private final Page page = new Page();
  private final long everyNs;
  private final int widthPx;
  private final boolean ofViolation;
  private final Deque<BufferedImage> frames = new ArrayDeque<>();
  private String name = "";
  private long nextNs;
  private int framesLeft = Integer.MAX_VALUE;
  private boolean isViolated;

  /**
   * @param everyNs virtual time between two frames, above 0
   * @param widthPx of the picture
   * @param ofViolation whether to keep only the first violation, and no file without a violation
   */
  public GifRecorder(
      Obstacles obstacles, Layer layer, long everyNs, int widthPx, boolean ofViolation) {
    if (everyNs <= 0 || widthPx <= 0) {
      throw new IllegalArgumentException(
          "a frame every " + everyNs + " ns, " + widthPx + " px wide: expected both above 0");
    }
    scene = new Scene(obstacles);
    this.layer = layer;
    this.everyNs = everyNs;
    this.widthPx = widthPx;
    this.ofViolation = ofViolation;
  }

  @Override
  public void started(TraceHeader header) {
    name = header.scenario() + ", seed " + header.scenarioSeed();
  }

  @Override
  public void observed(TraceEvent event) {
    takeUntil(event.timeNs());
    scene.observe(event);
    layer.observe(event);
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    if (ofViolation && !isViolated) {
      isViolated = true;
      framesLeft = FRAMES_AFTER;
    }
  }

  @Override
  public void finished(SimResult result) {
    takeUntil(result.endNs() + 1);
  }

  /** Whether there is anything to be seen. */
  public boolean hasFrames() {
    return !frames.isEmpty() && (isViolated || !ofViolation);
  }

  /** Writes the frames, which play for ever. */
  public void writeGif(OutputStream out) throws IOException {
    ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.prepareWriteSequence(null);
      boolean isFirst = true;
      for (BufferedImage frame : frames) {
        writer.writeToSequence(new IIOImage(frame, null, control(writer, frame, isFirst)), null);
        isFirst = false;
      }
      writer.endWriteSequence();
    } finally {
      writer.dispose();
    }
  }

  private static IIOMetadata control(ImageWriter writer, BufferedImage frame, boolean isFirst)
      throws IOException {
    IIOMetadata metadata =
        writer.getDefaultImageMetadata(
            new ImageTypeSpecifier(frame), writer.getDefaultWriteParam());
    IIOMetadataNode root = new IIOMetadataNode(FORMAT);
    IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
    control.setAttribute("disposalMethod", "none");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "FALSE");
    control.setAttribute("transparentColorIndex", "0");
    control.setAttribute("delayTime", Integer.toString(SHOWN_CS));
    root.appendChild(control);
    if (isFirst) {
      IIOMetadataNode forEver = new IIOMetadataNode("ApplicationExtension");
      forEver.setAttribute("applicationID", "NETSCAPE");
      forEver.setAttribute("authenticationCode", "2.0");
      forEver.setUserObject(new byte[] {1, 0, 0});
      IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
      extensions.appendChild(forEver);
      root.appendChild(extensions);
    }
    metadata.mergeTree(FORMAT, root);
    return metadata;
  }

  private void takeUntil(long timeNs) {
    while (nextNs < timeNs && framesLeft > 0) {
      scene.advance(nextNs);
      long tenths = nextNs / TENTH_NS;
      String title = name + ", at " + tenths / 10 + "." + tenths % 10 + " s";
      frames.add(Filmstrip.scaled(page.paint(scene, layer, title), widthPx));
      if (ofViolation && !isViolated && frames.size() > FRAMES_BEFORE) {
        frames.remove();
      }
      if (framesLeft != Integer.MAX_VALUE) {
        framesLeft--;
      }
      nextNs += everyNs;
    }
  }
}
