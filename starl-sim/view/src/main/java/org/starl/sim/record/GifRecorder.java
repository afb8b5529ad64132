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
import org.starl.sim.SimResult;
import org.starl.spec.SpecReport;

/**
 * Records an animated GIF of a run: one frame per {@code everyNs} of simulated time. It can also
 * record only the time around the first violation.
 */
public final class GifRecorder extends SceneRecorder {

  private static final String FORMAT = "javax_imageio_gif_image_1.0";

  /** Display time of a frame, in hundredths of a second. */
  private static final int SHOWN_CS = 5;

  /** Frames kept before and after a violation. */
  private static final int FRAMES_BEFORE = 60;

  private static final int FRAMES_AFTER = 20;

  private final long everyNs;
  private final int widthPx;
  private final boolean ofViolation;
  private final Deque<BufferedImage> frames = new ArrayDeque<>();
  private long nextNs;
  private int framesLeft = Integer.MAX_VALUE;
  private boolean isViolated;

  /**
   * @param everyNs simulated time between two frames, above 0
   * @param widthPx width of the GIF, above 0
   * @param ofViolation whether to keep only the frames around the first violation; none if there is
   *     none
   */
  public GifRecorder(
      Obstacles obstacles, Layer layer, long everyNs, int widthPx, boolean ofViolation) {
    super(obstacles, layer);
    if (everyNs <= 0 || widthPx <= 0) {
      throw new IllegalArgumentException(
          "a frame every " + everyNs + " ns, " + widthPx + " px wide: expected both above 0");
    }
    this.everyNs = everyNs;
    this.widthPx = widthPx;
    this.ofViolation = ofViolation;
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
    takeBefore(result.endNs() + 1);
  }

  /** Whether there are frames to write. */
  public boolean hasFrames() {
    return !frames.isEmpty() && (isViolated || !ofViolation);
  }

  /** Writes the frames as a GIF that repeats forever. */
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
      IIOMetadataNode repeat = new IIOMetadataNode("ApplicationExtension");
      repeat.setAttribute("applicationID", "NETSCAPE");
      repeat.setAttribute("authenticationCode", "2.0");
      repeat.setUserObject(new byte[] {1, 0, 0});
      IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
      extensions.appendChild(repeat);
      root.appendChild(extensions);
    }
    metadata.mergeTree(FORMAT, root);
    return metadata;
  }

  @Override
  void takeBefore(long timeNs) {
    while (nextNs < timeNs && framesLeft > 0) {
      frames.add(Filmstrip.scaled(paint(nextNs), widthPx));
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
