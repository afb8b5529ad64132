package org.starl.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.shape.JsonWriter;

/**
 * Writes a run's trace: the header, one line per event, then the end. Buffers its output. Not
 * thread-safe.
 *
 * <p>Because a robot cannot react to a full disk, {@link #record} does not throw: the first failure
 * is kept, nothing more is written, and {@link #close} throws it. Long-running callers should check
 * {@link #failure} from time to time.
 */
public final class TraceWriter implements TraceSink, Closeable {

  private static final int FLUSH_AT_BYTES = 1 << 15;

  private final OutputStream out;
  private final JsonWriter buffer = new JsonWriter();
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
   * Writes the last line. A trace without it counts as cut off.
   *
   * @param timeNs end of the run, in ns from its start
   */
  public void end(long timeNs) {
    end(timeNs, List.of());
  }

  /**
   * The same.
   *
   * @param unfinished robots whose apps have not ended
   */
  public void end(long timeNs, List<RobotId> unfinished) {
    if (ended) {
      throw new IllegalStateException("the trace has ended already");
    }
    ended = true;
    TraceCodec.append(buffer, new TraceEnd(timeNs, events, unfinished));
    endLine();
  }

  /** Number of events recorded. */
  public long events() {
    return events;
  }

  /** The first write failure, or null. */
  public @Nullable IOException failure() {
    return failure;
  }

  /**
   * Writes the buffer to the stream and flushes it, so that a crash of this program loses nothing.
   */
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

  /** Writes the buffer and closes the stream. */
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
