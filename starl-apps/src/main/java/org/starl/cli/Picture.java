package org.starl.cli;

import java.awt.image.BufferedImage;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.sim.SimObserver;
import org.starl.sim.record.Moment;
import org.starl.sim.record.PictureRecorder;

/** The picture of a run, for a file. */
final class Picture {

  private final PictureRecorder recorder;
  private final String file;

  Picture(Plan plan, Moment moment, String file) {
    recorder = new PictureRecorder(plan.obstacles(), plan.layer(), moment);
    this.file = file;
  }

  SimObserver recorder() {
    return recorder;
  }

  /** Writes the file, after the run; nothing if an error ended the run before the picture. */
  void write() throws IOException {
    @Nullable BufferedImage picture = recorder.picture();
    if (picture != null) {
      try (OutputFile out = new OutputFile("--png", file)) {
        ImageIO.write(picture, "png", out.stream());
      }
    }
  }
}
