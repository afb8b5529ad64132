package org.starl.trace;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;

/**
 * Reads exactly what {@link TraceWriter} writes: the same keys in the same order without white
 * space. Anything else is a {@link JsonFormatException} that names file, line, column and what was
 * expected. A trace that was cut off between two lines can be read, but has no {@link #end}. Not
 * thread-safe.
 */
public final class TraceReader implements Closeable {

  private final String file;
  private final LineSource lines;
  private final EventParser parser;
  private final TraceHeader header;
  private long events;
  private @Nullable TraceEnd end;

  /**
   * Reads the header.
   *
   * @param file the source's name in errors
   * @param in closed by {@link #close}; by the caller if this constructor throws
   * @param vocabulary the shapes of the values in the trace
   */
  public TraceReader(String file, InputStream in, Vocabulary vocabulary) throws IOException {
    this(file, in, header -> vocabulary);
  }

  /**
   * Reads the header.
   *
   * @param vocabularyOf the shapes of the values in a trace with this header
   */
  public TraceReader(String file, InputStream in, Function<TraceHeader, Vocabulary> vocabularyOf)
      throws IOException {
    this.file = file;
    this.lines = new LineSource(file, in);
    String first = lines.next();
    this.header =
        new EventParser(Vocabulary.NONE)
            .header(new JsonReader(file, 1, first == null ? "" : first));
    this.parser = new EventParser(vocabularyOf.apply(header));
  }

  public TraceHeader header() {
    return header;
  }

  /** Reads the next event; null after the last. */
  public @Nullable TraceEvent next() throws IOException {
    String text = lines.next();
    if (text == null) {
      return null;
    }
    JsonReader line = new JsonReader(file, lines.lineNumber(), text);
    if (end != null) {
      throw line.expected("nothing after the line of kind end");
    }
    String kind = line.text("{\"kind\":");
    long timeNs = line.number(",\"timeNs\":");
    if (kind.equals("end")) {
      end = parser.traceEnd(line, timeNs, events);
      return next();
    }
    TraceEvent event = parser.event(line, kind, timeNs);
    events++;
    return event;
  }

  /** The line number of the last event read, from 1. */
  public long lineNumber() {
    return lines.lineNumber();
  }

  /**
   * The trace's end, after {@link #next} returned null; null before, and if the trace was cut off.
   */
  public @Nullable TraceEnd end() {
    return end;
  }

  @Override
  public void close() throws IOException {
    lines.close();
  }
}
