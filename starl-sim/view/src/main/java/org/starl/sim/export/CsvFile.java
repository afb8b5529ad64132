package org.starl.sim.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;

/**
 * Writes rows of comma-separated values, as RFC 4180 has them but for the line ends, which are line
 * feeds: a value with a comma, a quote or a line end stands in quotes, and quotes in it are doubled.
 */
final class CsvFile implements Closeable {

  private static final double NS_PER_S = 1e9;

  private final Writer out;

  CsvFile(OutputStream out) {
    this.out = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
  }

  /** A time, in seconds. */
  static double seconds(long timeNs) {
    return timeNs / NS_PER_S;
  }

  void row(Object... values) {
    try {
      for (int i = 0; i < values.length; i++) {
        out.write(i == 0 ? "" : ",");
        out.write(text(String.valueOf(values[i])));
      }
      out.write("\n");
    } catch (IOException e) {
      throw new UncheckedIOException("the table cannot be written", e);
    }
  }

  private static String text(String value) {
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      if (c == ',' || c == '"' || c == '\n' || c == '\r') {
        return '"' + value.replace("\"", "\"\"") + '"';
      }
    }
    return value;
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
