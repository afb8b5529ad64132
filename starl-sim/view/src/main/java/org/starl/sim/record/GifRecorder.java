package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
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
import org.starl.sim.Failure;
import org.starl.sim.SimResult;

/**
 * Writes an animated GIF of a run, which repeats forever: one frame per {@code everyNs} of simulated
 * time. It can also write only the time around the first violation. It holds no frame that it has
 * written.
 */
public final class GifRecorder extends SceneRecorder implements Closeable {

  private static final String FORMAT = "javax_imageio_gif_image_1.0";

  /** Display time of a frame, in hundredths of a second. */
  private static final int SHOWN_CS = 5;

  /** Frames kept before and after a violation. */
  private static final int FRAMES_BEFORE = 60;

  private static final int FRAMES_AFTER = 20;

  private final long everyNs;
  private final int widthPx;
  private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
  private final ImageOutputStream stream;

  /** Waiting for a violation. */
  private final Deque<BufferedImage> frames = new ArrayDeque<>();

  private long nextNs;
  private int framesLeft = Integer.MAX_VALUE;
  private boolean isWritten;
  private boolean hasBegun;

  /**
   * @param everyNs simulated time between two frames, above 0
   * @param widthPx width of the GIF, above 0
   * @param ofViolation whether to write only the frames around the first violation; nothing if there
   *     is none
   */
  public GifRecorder(
      OutputStream out,
      Obstacles obstacles,
      Layer layer,
      long everyNs,
      int widthPx,
      boolean ofViolation) {
    super(obstacles, layer);
    if (everyNs <= 0 || widthPx <= 0) {
      throw new IllegalArgumentException(
          "a frame every " + everyNs + " ns, " + widthPx + " px wide: expected both above 0");
    }
    this.everyNs = everyNs;
    this.widthPx = widthPx;
    isWritten = !ofViolation;
    stream = new MemoryCacheImageOutputStream(out);
    writer.setOutput(stream);
  }

  @Override
  public void wentWrong(Failure failure) {
    super.wentWrong(failure);
    if (!isWritten && failure.kind() == Failure.Kind.VIOLATED) {
      isWritten = true;
      framesLeft = FRAMES_AFTER;
    }
  }

  @Override
  public void finished(SimResult result) {
    takeBefore(result.endNs() + 1);
  }

  @Override
  void takeBefore(long timeNs) {
    while (nextNs < timeNs && framesLeft > 0) {
      frames.add(Filmstrip.scaled(paint(nextNs), widthPx));
      nextNs += everyNs;
      if (isWritten) {
        framesLeft--;
        writeFrames();
      } else if (frames.size() > FRAMES_BEFORE) {
        frames.remove();
      }
    }
  }

  private void writeFrames() {
    try {
      while (!frames.isEmpty()) {
        BufferedImage frame = frames.remove();
        if (!hasBegun) {
          writer.prepareWriteSequence(null);
        }
        writer.writeToSequence(new IIOImage(frame, null, control(writer, frame, !hasBegun)), null);
        hasBegun = true;
        stream.flush();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    try (stream) {
      if (isWritten) {
        writeFrames();
      }
      if (hasBegun) {
        writer.endWriteSequence();
      }
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
}
