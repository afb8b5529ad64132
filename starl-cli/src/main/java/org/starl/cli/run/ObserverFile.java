package org.starl.cli.run;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.apps.Product;
import org.starl.cli.command.OutputFile;
import org.starl.sim.SimObserver;
import org.starl.sim.record.PictureRecorder;
import org.starl.sim.record.PictureTime;

/**
 * An observer that writes a file, if the user requested one; else it does nothing. The file is
 * written even if the run fails.
 */
public final class ObserverFile implements Closeable {

  private final SimObserver observer;
  private final Closeable writer;
  private final @Nullable OutputFile file;

  private ObserverFile(SimObserver observer, Closeable writer, @Nullable OutputFile file) {
    this.observer = observer;
    this.writer = writer;
    this.file = file;
  }

  /**
   * A file that is written during the run.
   *
   * @param option the option's name, for errors: {@code --csv}
   * @param name of the file; null for none
   * @param maker makes the observer that writes to the stream
   */
  public static <T extends SimObserver & Closeable> ObserverFile of(
      String option, @Nullable String name, Function<OutputStream, T> maker) {
    if (name == null) {
      return new ObserverFile(new SimObserver() {}, () -> {}, null);
    }
    OutputFile file = new OutputFile(option, name);
    T writer = maker.apply(file.stream());
    return new ObserverFile(writer, writer, file);
  }

  /** A file with the {@code content} that {@code recorder} has after the run. */
  static ObserverFile after(
      String option, String name, SimObserver recorder, Product.Content content) {
    OutputFile file = new OutputFile(option, name);
    return new ObserverFile(recorder, () -> content.write(file.stream()), file);
  }

  /** One picture; no file if an error ended the run before the picture. */
  static ObserverFile picture(String option, String name, Plan plan, PictureTime moment) {
    PictureRecorder recorder = new PictureRecorder(plan.obstacles(), plan.layer(), moment);
    return after(
        option,
        name,
        recorder,
        out -> {
          if (recorder.hasPicture()) {
            recorder.writePng(out);
          }
        });
  }

  public SimObserver observer() {
    return observer;
  }

  /** Whether the file has any content. */
  boolean isWritten() {
    return file != null && file.isWritten();
  }

  @Override
  public void close() throws IOException {
    try (file) {
      writer.close();
    }
  }
}
