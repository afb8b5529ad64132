package org.starl.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;

/**
 * Writes a run's trace: the header, then a line an event, then the end. Buffers by itself. Not for
 * use by several threads at once.
 *
 * <p>A robot can do nothing about a full disk, so {@link #record} never throws for it: the first
 * failure is kept, nothing more is written, and {@link #close} throws it. Whoever runs for long asks
 * {@link #failure} now and then.
 */
public final class TraceWriter implements TraceSink, Closeable {

  private static final int FLUSH_AT_BYTES = 1 << 15;

  private final OutputStream out;
  private final LineBuffer buffer = new LineBuffer();
  private long events;
  private boolean ended;
  private @Nullable IOException failure;

  /** Writes the header; {@link #close} closes {@code out}. */
  public TraceWriter(OutputStream out, TraceHeader header) {
    this.out = out;
    TraceCodec.append(buffer, header);
    endLine();
  }

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    if (ended) {
      throw new IllegalStateException("an event after the end of the trace: " + event);
    }
    TraceCodec.append(buffer, event);
    events++;
    endLine();
  }

  /**
   * The run is over: writes the trace's last line. Without it, the trace counts as cut off.
   *
   * @param timeNs when the run ended, in ns from its start
   */
  public void end(long timeNs) {
    if (ended) {
      throw new IllegalStateException("the trace has its end already");
    }
    ended = true;
    TraceCodec.append(buffer, new TraceEnd(timeNs, events));
    endLine();
  }

  /** How many events were recorded. */
  public long events() {
    return events;
  }

  /** The first failure to write, or null. */
  public @Nullable IOException failure() {
    return failure;
  }

  /** Writes what is buffered, so that it is out whatever becomes of this program. */
  public void flush() {
    drain();
    if (failure == null) {
      try {
        out.flush();
      } catch (IOException e) {
        failure = e;
      }
    }
  }

  /** Writes what is buffered, and closes the stream. */
  @Override
  public void close() throws IOException {
    drain();
    try (out) {
      if (failure != null) {
        throw failure;
      }
      out.flush();
    }
  }

  private void endLine() {
    buffer.ascii('\n');
    if (buffer.length() >= FLUSH_AT_BYTES) {
      drain();
    }
  }

  private void drain() {
    if (failure == null) {
      try {
        buffer.writeTo(out);
      } catch (IOException e) {
        failure = e;
      }
    }
    buffer.clear();
  }
}
