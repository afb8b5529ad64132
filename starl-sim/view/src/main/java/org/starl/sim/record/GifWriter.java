package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes an animated GIF, which repeats for ever. */
final class GifWriter implements AnimationRecorder.FrameWriter {

  private static final String FORMAT = "javax_imageio_gif_image_1.0";

  /** Display time of a frame, in hundredths of a second. */
  private static final int SHOWN_CS = 5;

  private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
  private final ImageOutputStream stream;
  private boolean hasBegun;

  /**
   * @param out closed by {@link #close}
   */
  GifWriter(OutputStream out) {
    stream = new MemoryCacheImageOutputStream(out);
    writer.setOutput(stream);
  }

  @Override
  public void write(BufferedImage frame) throws IOException {
    if (!hasBegun) {
      writer.prepareWriteSequence(null);
    }
    writer.writeToSequence(new IIOImage(frame, null, control(frame, !hasBegun)), null);
    hasBegun = true;
    stream.flush();
  }

  @Override
  public void close() throws IOException {
    try (stream) {
      if (hasBegun) {
        writer.endWriteSequence();
      }
    } finally {
      writer.dispose();
    }
  }

  private IIOMetadata control(BufferedImage frame, boolean isFirst) throws IOException {
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
