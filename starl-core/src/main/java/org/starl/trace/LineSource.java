package org.starl.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.shape.JsonFormatException;

/**
 * Splits a stream into lines at {@code \n}; requires UTF-8 and a line end after the last line. A byte order mark and {@code \r\n}, which
 * other programs write on Windows, are read.
 */
final class LineSource implements Closeable {

  private static final int MAX_LINE_BYTES = 1 << 26;

  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final String file;
  private final InputStream in;
  private final byte[] chunk = new byte[1 << 16];
  private int from;
  private int to;
  private byte[] line = new byte[1 << 10];
  private int length;
  private long lineNumber;

  LineSource(String file, InputStream in) {
    this.file = file;
    this.in = in;
  }

  /** The number of the last line read, from 1. */
  long lineNumber() {
    return lineNumber;
  }

  /** Reads the next line; null after the last. */
  @Nullable String next() throws IOException {
    length = 0;
    while (true) {
      if (from == to && !fill()) {
        if (length > 0) {
          throw new JsonFormatException(
              file, lineNumber + 1, "expected a whole line: the trace was cut off inside it");
        }
        return null;
      }
      int end = from;
      while (end < to && chunk[end] != '\n') {
        end++;
      }
      keep(end);
      from = end;
      if (end < to) {
        from++;
        lineNumber++;
        return decode();
      }
    }
  }

  @Override
  public void close() throws IOException {
    in.close();
  }

  private boolean fill() throws IOException {
    from = 0;
    to = Math.max(0, in.read(chunk));
    return to > 0;
  }

  private void keep(int end) throws JsonFormatException {
    int more = end - from;
    if (length + more > MAX_LINE_BYTES) {
      throw new JsonFormatException(
          file, lineNumber + 1, "expected a line of at most " + MAX_LINE_BYTES + " bytes");
    }
    if (length + more > line.length) {
      line = Arrays.copyOf(line, Math.max(2 * line.length, length + more));
    }
    System.arraycopy(chunk, from, line, length, more);
    length += more;
  }

  private String decode() throws JsonFormatException {
    if (length > 0 && line[length - 1] == '\r') {
      length--;
    }
    try {
      String text =
          StandardCharsets.UTF_8
              .newDecoder()
              .onMalformedInput(CodingErrorAction.REPORT)
              .onUnmappableCharacter(CodingErrorAction.REPORT)
              .decode(ByteBuffer.wrap(line, 0, length))
              .toString();
      return lineNumber == 1 && text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
    } catch (CharacterCodingException e) {
      throw new JsonFormatException(file, lineNumber, "expected text in UTF-8");
    }
  }
}
