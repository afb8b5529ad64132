package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import org.starl.apps.Plan;
import org.starl.sim.SimObserver;
import org.starl.sim.record.PictureRecorder;
import org.starl.sim.record.PictureTime;

/** Writes one picture of a run to a file. */
final class Picture implements Closeable {

  private final PictureRecorder recorder;
  private final OutputFile file;

  /**
   * @param option the option's name, for errors: {@code --png}
   */
  Picture(Plan plan, PictureTime moment, String option, String name) {
    recorder = new PictureRecorder(plan.obstacles(), plan.layer(), moment);
    file = new OutputFile(option, name);
  }

  SimObserver recorder() {
    return recorder;
  }

  boolean isTaken() {
    return recorder.hasPicture();
  }

  /** Writes the file after the run. Writes none if an error ended the run before the picture. */
  @Override
  public void close() throws IOException {
    try (file) {
      if (recorder.hasPicture()) {
        recorder.writePng(file.stream());
      }
    }
  }
}
