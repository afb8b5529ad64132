package org.starl.sim.check;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;

/**
 * Compares what is written to it with a reference, byte by byte, and keeps the first line that
 * differs. An end that comes too early, on either side, is a line that differs.
 */
final class LineComparer extends OutputStream {

  /** The text of a line that one side does not have. */
  static final String NOTHING = "(nothing more)";

  /** The first difference; lines count from 1. */
  record DifferentLines(long line, String reference, String written) {}

  private final InputStream reference;
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private long lineNumber = 1;
  private @Nullable String referenceLine;
  private boolean lineIsComplete;

  /**
   * @param reference buffered; its owner closes it
   */
  LineComparer(InputStream reference) {
    this.reference = reference;
  }

  @Override
  public void write(int b) throws IOException {
    if (lineIsComplete) {
      return;
    }
    byte written = (byte) b;
    if (referenceLine == null) {
      int expected = reference.read();
      if (expected != (written & 0xFF)) {
        referenceLine = expected < 0 && line.size() == 0 ? NOTHING : restOfReference(expected);
      }
    }
    if (written != '\n') {
      line.write(written);
    } else if (referenceLine == null) {
      line.reset();
      lineNumber++;
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

  /** How many whole lines were equal before the first difference. */
  long equalLines() {
    return lineNumber - 1;
  }

  /** The first difference, or null; call it once, when all was written. */
  @Nullable DifferentLines difference() throws IOException {
    if (referenceLine == null) {
      int next = reference.read();
      if (next < 0) {
        return null;
      }
      referenceLine = restOfReference(next);
      return new DifferentLines(lineNumber, referenceLine, line.size() == 0 ? NOTHING : text());
    }
    return new DifferentLines(lineNumber, referenceLine, text());
  }

  /** The equal beginning of the line, then the reference's own end from {@code next} on. */
  private String restOfReference(int next) throws IOException {
    ByteArrayOutputStream whole = new ByteArrayOutputStream();
    line.writeTo(whole);
    for (int b = next; b >= 0 && b != '\n'; b = reference.read()) {
      whole.write(b);
    }
    return whole.toString(StandardCharsets.UTF_8);
  }

  private String text() {
    return line.toString(StandardCharsets.UTF_8);
  }
}
