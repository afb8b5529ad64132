package org.starl.sim.record;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Writes pictures as PNG. */
public final class Png {

  private Png() {}

  /**
   * Writes a picture. The cache is in memory: one in a file is removed when the process ends, so
   * none can be made by a command that a signal ends and that writes what it has.
   */
  public static void write(BufferedImage image, OutputStream out) throws IOException {
    try (ImageOutputStream cache = new MemoryCacheImageOutputStream(out)) {
      ImageIO.write(image, "png", cache);
    }
  }
}
