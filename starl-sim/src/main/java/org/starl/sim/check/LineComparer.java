package org.starl.sim.check;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.starl.sim.SimObserver;
import org.starl.sim.check.Determinism.Difference;
import org.starl.trace.TraceEvent;

/**
 * Compares written bytes with a reference and keeps the first line that differs. A premature end of
 * either side is a difference. As an observer, before the recorder, it also keeps the event of that line.
 */
final class LineComparer extends OutputStream implements SimObserver {

  /** The text of a missing line. */
  static final String NOTHING = "(nothing more)";

  private final InputStream reference;
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private final Deque<TraceEvent> unwritten = new ArrayDeque<>();
  private long lineNumber = 1;
  private @Nullable String referenceLine;
  private boolean lineIsComplete;

  /**
   * @param reference buffered; closed by its owner
   */
  LineComparer(InputStream reference) {
    this.reference = reference;
  }

  @Override
  public void observed(TraceEvent event) {
    if (referenceLine == null) {
      unwritten.add(event);
    }
  }

  @Override
  public void write(int b) throws IOException {
    if (lineIsComplete) {
      return;
    }
    byte written = (byte) b;
    if (referenceLine == null) {
      int expected = next();
      if (expected != (written & 0xFF)) {
        referenceLine = expected < 0 && line.size() == 0 ? NOTHING : restOfReference(expected);
      }
    }
    if (written != '\n') {
      line.write(written);
    } else if (referenceLine == null) {
      line.reset();
      if (lineNumber++ > 1) { // the first is the header
        unwritten.poll();
      }
    } else {
      lineIsComplete = true;
    }
  }

  @Override
  public void write(byte[] bytes, int from, int length) throws IOException {
    for (int i = from; i < from + length && !lineIsComplete; i++) {
      write(bytes[i]);
    }
  }

  /** The next byte of the reference. Editors and git may end lines with CR LF; a trace has no other CR. */
  private int next() throws IOException {
    int next = reference.read();
    while (next == '\r') {
      next = reference.read();
    }
    return next;
  }

  /** The number of complete equal lines before the first difference. */
  long equalLines() {
    return lineNumber - 1;
  }

  /**
   * The first difference, or null; call it once, after the last write.
   *
   * @param referenceName name of the run that wrote the reference
   * @param writtenName name of the other run
   */
  @Nullable Difference difference(String referenceName, String writtenName) throws IOException {
    String writtenLine = line.toString(StandardCharsets.UTF_8);
    if (referenceLine == null) {
      int next = next();
      if (next < 0) {
        return null;
      }
      referenceLine = restOfReference(next);
      writtenLine = line.size() == 0 ? NOTHING : writtenLine;
    }
    TraceEvent event = lineNumber > 1 ? unwritten.peek() : null;
    return new Difference(
        referenceName, writtenName, lineNumber, referenceLine, writtenLine, event);
  }

  /**
   * The equal beginning of the line, then the rest of the reference's line from {@code next} on.
   */
  private String restOfReference(int next) throws IOException {
    ByteArrayOutputStream whole = new ByteArrayOutputStream();
    line.writeTo(whole);
    for (int b = next; b >= 0 && b != '\n'; b = next()) {
      whole.write(b);
    }
    return whole.toString(StandardCharsets.UTF_8);
  }
}
