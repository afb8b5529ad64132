package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PngTest {

  @AfterEach
  void usualFolder() {
    ImageIO.setCacheDirectory(null);
  }

  /** A process that a signal ends can make no file that is removed at its end. */
  @Test
  void noFileIsNeeded(@TempDir Path folder) throws IOException {
    Path gone = Files.createDirectory(folder.resolve("gone"));
    ImageIO.setCacheDirectory(gone.toFile());
    Files.delete(gone);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Png.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), out);
    assertThat(out.toByteArray()).startsWith(0x89, 'P', 'N', 'G');
  }
}
