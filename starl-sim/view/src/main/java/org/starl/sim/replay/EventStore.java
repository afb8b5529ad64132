package org.starl.sim.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntToLongFunction;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.TraceWriter;
import org.starl.trace.Vocabulary;

/**
 * A list of events to which one thread appends while others read the first {@link #size} events. It
 * keeps them in chunks, in memory or as a compressed trace in a temporary file, which rounds numbers
 * as {@link TraceCodec#rounded} does. No thread waits for a lock to read an event in memory.
 */
final class EventStore {

  private static final int SHIFT = 12;
  private static final int CHUNK = 1 << SHIFT;

  /** Chunks of the file that are also in memory, the latest read ones. */
  private static final int MOST_READ = 24;

  private static final TraceHeader HEADER = new TraceHeader("", "", 0, 0, Map.of(), List.of());

  /** Either in memory or in the file. */
  private static final class Chunk {
    private final long firstNs;
    private TraceEvent @Nullable [] events;
    private long fileOffset;
    private int fileBytes;

    Chunk(long firstNs, TraceEvent[] events) {
      this.firstNs = firstNs;
      this.events = events;
    }
  }

  private final AppendOnlyList<Chunk> chunks = new AppendOnlyList<>();
  private final Map<Long, TraceEvent[]> read = new LinkedHashMap<>(MOST_READ, 0.75f, true);
  private TraceEvent[] last = {};
  // The shapes of all events in the file.
  private Vocabulary vocabulary = Vocabulary.NONE;
  // Not a FileChannel, which an interrupt of a thread that reads or writes would close.
  private @Nullable RandomAccessFile file;

  // Written after the event, and read before it.
  private volatile int size;

  /**
   * Appends an event; only one thread may call it.
   *
   * @param inMemory whether there is memory for its chunk
   * @throws BadInput if there is neither memory nor a temporary file
   */
  void add(TraceEvent event, boolean inMemory) {
    int index = size;
    int place = index & (CHUNK - 1);
    if (place == 0) {
      last = new TraceEvent[CHUNK];
      chunks.add(new Chunk(event.timeNs(), last));
    }
    last[place] = event;
    size = Math.addExact(index, 1);
    if (place == CHUNK - 1 && !inMemory) {
      try {
        write(chunks.get(index >>> SHIFT));
      } catch (IOException e) {
        throw new BadInput(
            "too many events for the memory: from event %d on at %d s they need a temporary file, which cannot be written (%s); expected a shorter run, or more memory for Java (STARL_JAVA_OPTS=-Xmx8g)"
                .formatted(index, event.timeNs() / 1_000_000_000, e));
      }
    }
  }

  int size() {
    return size;
  }

  TraceEvent get(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("number " + index + " of " + size);
    }
    Chunk chunk = chunks.get(index >>> SHIFT);
    TraceEvent[] events = chunk.events;
    return (events == null ? read(chunk) : events)[index & (CHUNK - 1)];
  }

  /** Number of the first event after {@code timeNs}; {@link #size} if there is none. */
  int firstAfter(long timeNs) {
    int all = size;
    int chunk =
        firstAfter(timeNs, 0, (all + CHUNK - 1) >>> SHIFT, number -> chunks.get(number).firstNs);
    return firstAfter(
        timeNs,
        Math.max(0, chunk - 1) << SHIFT,
        Math.min(all, chunk << SHIFT),
        index -> get(index).timeNs());
  }

  private static int firstAfter(long timeNs, int first, int end, IntToLongFunction timeOf) {
    int from = first;
    int to = end;
    while (from < to) {
      int middle = (from + to) >>> 1;
      if (timeOf.applyAsLong(middle) <= timeNs) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from;
  }

  private synchronized void write(Chunk chunk) throws IOException {
    RandomAccessFile target = file;
    if (target == null) {
      target = temporaryFile();
      file = target;
    }
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    Deflater deflater = new Deflater(Deflater.BEST_SPEED);
    try (TraceWriter out = new TraceWriter(new DeflaterOutputStream(bytes, deflater), HEADER)) {
      for (TraceEvent event : last) {
        out.record(event);
        vocabulary = vocabulary.with(event);
      }
    } finally {
      deflater.end();
    }
    chunk.fileOffset = target.length();
    chunk.fileBytes = bytes.size();
    target.seek(chunk.fileOffset);
    target.write(bytes.toByteArray());
    chunk.events = null;
  }

  private static RandomAccessFile temporaryFile() throws IOException {
    Path path = Files.createTempFile("starl", ".events");
    RandomAccessFile opened = new RandomAccessFile(path.toFile(), "rw");
    try {
      Files.delete(path);
    } catch (IOException e) {
      // Windows keeps an open file.
      path.toFile().deleteOnExit();
    }
    return opened;
  }

  private synchronized TraceEvent[] read(Chunk chunk) {
    TraceEvent[] events = read.get(chunk.fileOffset);
    if (events == null) {
      events = inflated(chunk);
      if (read.size() == MOST_READ) {
        read.remove(read.keySet().iterator().next());
      }
      read.put(chunk.fileOffset, events);
    }
    return events;
  }

  private TraceEvent[] inflated(Chunk chunk) {
    byte[] bytes = new byte[chunk.fileBytes];
    RandomAccessFile source = Objects.requireNonNull(file);
    TraceEvent[] events = new TraceEvent[CHUNK];
    try {
      source.seek(chunk.fileOffset);
      source.readFully(bytes);
      InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(bytes));
      try (TraceReader reader = new TraceReader("the temporary file of events", in, vocabulary)) {
        for (int i = 0; i < CHUNK; i++) {
          events[i] = reader.next();
        }
      }
    } catch (IOException e) {
      throw new BadInput("the temporary file of events cannot be read (" + FailureText.of(e) + ")");
    }
    return events;
  }
}
