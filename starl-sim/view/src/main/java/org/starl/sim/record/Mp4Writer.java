package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jcodec.api.SequenceEncoder;
import org.jcodec.common.Codec;
import org.jcodec.common.Format;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Rational;
import org.jspecify.annotations.Nullable;

/**
 * Writes video in H.264, in an MP4 file. Its index comes first and is known last, so the file is
 * made as a temporary one.
 */
final class Mp4Writer implements AnimationRecorder.FrameWriter {

  private static final Rational FRAMES_PER_S = Rational.R(20, 1);
  private static final int HALF = 128;

  private final OutputStream out;
  private @Nullable Path file;
  private @Nullable FileChannelWrapper channel;
  private @Nullable SequenceEncoder encoder;

  /**
   * @param out closed by {@link #close}
   */
  Mp4Writer(OutputStream out) {
    this.out = out;
  }

  @Override
  public void write(BufferedImage frame) throws IOException {
    if (encoder == null) {
      file = Files.createTempFile("starl", ".mp4");
      channel = NIOUtils.writableChannel(file.toFile());
      encoder = new SequenceEncoder(channel, FRAMES_PER_S, Format.MOV, Codec.H264, null);
    }
    encoder.encodeNativeFrame(picture(frame));
  }

  /** With an even width and height, as the codec needs. */
  private static Picture picture(BufferedImage frame) {
    int width = frame.getWidth() & ~1;
    int height = frame.getHeight() & ~1;
    Picture picture = Picture.create(width, height, ColorSpace.RGB);
    int[] line = new int[width];
    byte[] data = picture.getPlaneData(0);
    int i = 0;
    for (int y = 0; y < height; y++) {
      frame.getRGB(0, y, width, 1, line, 0, width);
      for (int rgb : line) {
        data[i++] = (byte) ((rgb >> 16 & 0xFF) - HALF);
        data[i++] = (byte) ((rgb >> 8 & 0xFF) - HALF);
        data[i++] = (byte) ((rgb & 0xFF) - HALF);
      }
    }
    return picture;
  }

  @Override
  public void close() throws IOException {
    try (out) {
      if (encoder != null && channel != null && file != null) {
        try {
          encoder.finish();
        } finally {
          channel.close();
        }
        Files.copy(file, out);
      }
    } finally {
      if (file != null) {
        Files.deleteIfExists(file);
      }
    }
  }
}
