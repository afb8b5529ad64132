package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.sim.SimObserver;

/** An observer that writes a file, if the user requested one; else it does nothing. */
final class ObserverFile implements Closeable {

  private final SimObserver observer;
  private final Closeable writer;
  private final @Nullable OutputFile file;

  private ObserverFile(SimObserver observer, Closeable writer, @Nullable OutputFile file) {
    this.observer = observer;
    this.writer = writer;
    this.file = file;
  }

  /**
   * @param name of the file; null for none
   * @param maker makes the observer that writes to the stream
   */
  static <T extends SimObserver & Closeable> ObserverFile of(
      String option, @Nullable String name, Function<OutputStream, T> maker) {
    if (name == null) {
      return new ObserverFile(new SimObserver() {}, () -> {}, null);
    }
    OutputFile file = new OutputFile(option, name);
    T writer = maker.apply(file.stream());
    return new ObserverFile(writer, writer, file);
  }

  SimObserver observer() {
    return observer;
  }

  @Override
  public void close() throws IOException {
    writer.close();
    if (file != null) {
      file.close();
    }
  }
}
