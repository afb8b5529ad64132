package org.starl.sim.export;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Function;
import org.starl.sim.SimObserver;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes events as rows of comma-separated values (RFC 4180, but with line feeds as line ends). A
 * value that contains a comma, a quote or a line end is put in quotes, and its quotes are doubled.
 */
public final class CsvTable implements SimObserver, Closeable {

  private final Writer out;
  private final List<Object> columns;
  private final Function<TraceEvent, List<Object>> values;

  /**
   * @param columns after the time
   * @param values of an event, without its time; empty if the event has no row
   */
  private CsvTable(
      OutputStream out, List<Object> columns, Function<TraceEvent, List<Object>> values) {
    this.out = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
    this.columns = columns;
    this.values = values;
  }

  /**
   * True motion: one row whenever a body joins, changes its speeds or leaves. Between two rows of a
   * robot its body moves with the constant speeds of the first.
   */
  public static CsvTable positions(OutputStream out) {
    return new CsvTable(
        out,
        List.of("robot", "event", "x_mm", "y_mm", "heading_rad", "mm_per_s", "rad_per_s"),
        CsvTable::position);
  }

  /**
   * Messages: one row per message that is sent (to a robot, or {@code *} for all robots in range),
   * delivered or dropped. The column {@code text} is the message, or the reason of a drop. {@code
   * from} and {@code seq} identify the message; a drop has no {@code channel}, {@code seq} or
   * {@code bytes}.
   */
  public static CsvTable messages(OutputStream out) {
    return new CsvTable(
        out, List.of("event", "from", "to", "channel", "seq", "bytes", "text"), CsvTable::message);
  }

  /** Variables: one row for each new value, the first one included. */
  public static CsvTable variables(OutputStream out) {
    return new CsvTable(
        out,
        List.of("robot", "source", "name", "value"),
        event ->
            event instanceof TraceEvent.Variable v
                ? List.of(v.robot(), v.source(), v.name(), v.value())
                : List.of());
  }

  private static List<Object> position(TraceEvent event) {
    return switch (event) {
      case TraceEvent.Joined e ->
          List.of(
              e.robot(), "joined", e.pose().xMm(), e.pose().yMm(), e.pose().headingRad(), 0.0, 0.0);
      case TraceEvent.Moved e ->
          List.of(
              e.robot(),
              "moved",
              e.pose().xMm(),
              e.pose().yMm(),
              e.pose().headingRad(),
              e.linearMmPerS(),
              e.angularRadPerS());
      case TraceEvent.Left e -> List.of(e.robot(), "left", "", "", "", "", "");
      default -> List.of();
    };
  }

  private static List<Object> message(TraceEvent event) {
    return switch (event) {
      case TraceEvent.Sent e ->
          List.of("sent", e.robot(), e.to(), e.channel(), e.seq(), e.bytes(), e.message());
      case TraceEvent.Delivered e ->
          List.of("delivered", e.from(), e.robot(), e.channel(), e.seq(), "", e.message());
      case TraceEvent.Dropped e -> List.of("dropped", e.from(), e.robot(), "", "", "", e.why());
      default -> List.of();
    };
  }

  @Override
  public void started(TraceHeader header) {
    row("time_s", columns);
  }

  @Override
  public void observed(TraceEvent event) {
    List<Object> row = values.apply(event);
    if (!row.isEmpty()) {
      row(Time.seconds(event.timeNs()), row);
    }
  }

  private void row(Object first, List<Object> others) {
    try {
      out.write(String.valueOf(first));
      for (Object value : others) {
        out.write("," + quoted(value.toString()));
      }
      out.write("\n");
    } catch (IOException e) {
      throw new UncheckedIOException("the table cannot be written", e);
    }
  }

  /** A value as a cell. */
  public static String quoted(String value) {
    boolean isPlain = value.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return isPlain ? value : '"' + value.replace("\"", "\"\"") + '"';
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
