package org.starl.sim;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceWriter;

/** Writes a run's trace. Close it after the run, even after a failure. */
public final class TraceRecorder implements SimObserver, Closeable {

  private final OutputStream out;
  private @Nullable TraceWriter writer;

  /**
   * @param out closed by {@link #close}
   */
  public TraceRecorder(OutputStream out) {
    this.out = out;
  }

  @Override
  public void started(TraceHeader header) {
    writer = new TraceWriter(out, header);
  }

  @Override
  public void observed(TraceEvent event) {
    begun().record(event);
  }

  @Override
  public void finished(SimResult result) {
    begun().end(result.endNs(), result.unfinished());
  }

  /**
   * Writes the remaining bytes.
   *
   * @throws IOException if this write or an earlier one failed
   */
  @Override
  public void close() throws IOException {
    if (writer == null) {
      out.close();
    } else {
      writer.close();
    }
  }

  private TraceWriter begun() {
    if (writer == null) {
      throw new IllegalStateException("an event before the start");
    }
    return writer;
  }
}
