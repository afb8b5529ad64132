package org.starl.sim.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import org.starl.sim.SimObserver;
import org.starl.time.Time;
import org.starl.trace.TraceHeader;

/**
 * Writes rows of comma-separated values (RFC 4180, but with line feeds as line ends). A value that
 * contains a comma, a quote or a line end is put in quotes, and its quotes are doubled.
 */
abstract sealed class CsvTable implements SimObserver, Closeable
    permits MessageTable, PositionTable, VariableTable {

  private final Writer out;
  private final String[] columns;

  CsvTable(OutputStream out, String... columns) {
    this.out = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
    this.columns = columns;
  }

  @Override
  public final void started(TraceHeader header) {
    row((Object[]) columns);
  }

  static double seconds(long timeNs) {
    return Time.seconds(timeNs);
  }

  final void row(Object... values) {
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
    boolean isPlain = value.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return isPlain ? value : '"' + value.replace("\"", "\"\"") + '"';
  }

  @Override
  public final void close() throws IOException {
    out.close();
  }
}
