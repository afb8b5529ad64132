package org.starl.launch;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongPredicate;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

/**
 * Reads the traces in a folder while the processes of a deployment write them, and those that begin
 * later. It only reads. A thread waits for each file to grow.
 */
public final class LiveTraces implements AutoCloseable {

  private static final long LOOK_MS = 50;
  private static final int LOOKS_PER_SCAN = 10;

  /** A robot that is alive writes at least every 2 s. */
  private static final long SILENT_NS = 5 * Time.NS_PER_S;

  private final Path folder;
  private final Function<TraceHeader, Vocabulary> vocabularyOf;
  private final LiveMerge merge;
  private final TraceHeader header;
  private final Consumer<String> console;
  private final Map<Path, Boolean> known = new TreeMap<>();
  private final CountDownLatch closing = new CountDownLatch(1);
  private final ProcessFact.Clock origin;
  private final LongSupplier realNs;
  private volatile boolean isClosed;

  /**
   * Begins to read.
   *
   * @param vocabularyOf the shapes of the values in a trace with this header
   * @param header of all traces
   * @param merge receives their events
   * @param console receives a line about each file that cannot be used
   * @throws BadInput if no trace is there yet, or one cannot be read
   */
  public LiveTraces(
      Path folder,
      Function<TraceHeader, Vocabulary> vocabularyOf,
      TraceHeader header,
      LiveMerge merge,
      Consumer<String> console) {
    this(folder, vocabularyOf, header, merge, console, RealClock::machineNs);
  }

  LiveTraces(
      Path folder,
      Function<TraceHeader, Vocabulary> vocabularyOf,
      TraceHeader header,
      LiveMerge merge,
      Consumer<String> console,
      LongSupplier realNs) {
    this.realNs = realNs;
    this.folder = folder;
    this.vocabularyOf = vocabularyOf;
    this.header = header;
    this.merge = merge;
    this.console = console;
    origin = earliest();
    Daemons.of("traces", this::scan).start();
  }

  /**
   * One of the traces in a folder; the first by name.
   *
   * @throws BadInput if there is none
   */
  public static String any(Path folder) {
    TreeSet<Path> files = files(folder);
    if (files.isEmpty()) {
      throw new BadInput(
          folder + ": no trace; expected the --folder of 'starl deploy run', with *.trace");
    }
    return files.first().toString();
  }

  private static TreeSet<Path> files(Path folder) {
    TreeSet<Path> files = new TreeSet<>();
    try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, "*.trace")) {
      for (Path file : all) {
        if (Files.isRegularFile(file)) { // a pipe would keep its reader waiting
          files.add(file);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      throw new BadInput(folder + ": cannot be read: " + FailureText.of(e));
    }
    return files;
  }

  /** The clock of the trace that began first. */
  private ProcessFact.Clock earliest() {
    ProcessFact.Clock first = null;
    for (Path file : files(folder)) {
      try (InputStream in = Files.newInputStream(file);
          TraceReader reader = new TraceReader(file.toString(), in, vocabularyOf)) {
        ProcessFact.Clock clock = clock(reader.next());
        if (clock != null && (first == null || clock.dateNs() < first.dateNs())) {
          first = clock;
        }
      } catch (IOException e) {
        console.accept(file + ": not used yet: " + e.getMessage());
      }
    }
    if (first == null) {
      throw new BadInput(
          folder + ": no trace that names its clock; expected those of a deployment");
    }
    return first;
  }

  private static ProcessFact.@Nullable Clock clock(@Nullable TraceEvent event) {
    return event instanceof Action action && action.fact() instanceof ProcessFact.Clock told
        ? told
        : null;
  }

  private void scan() {
    for (int look = 0; !isClosed; look++) {
      if (look % LOOKS_PER_SCAN == 0) {
        try {
          files(folder).forEach(this::begin);
        } catch (BadInput e) {
          console.accept(e.getMessage());
        }
      }
      pause();
    }
  }

  private void begin(Path file) {
    if (known.put(file, true) == null) {
      merge.follows();
      Daemons.of(file.getFileName() + " reader", () -> follow(file)).start();
    }
  }

  private void pause() {
    try {
      if (closing.await(LOOK_MS, TimeUnit.MILLISECONDS)) {
        isClosed = true;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      isClosed = true;
    }
  }

  private void follow(Path file) {
    CaughtUp past = new CaughtUp();
    try (Growing in = new Growing(Files.newInputStream(file), past);
        TraceReader reader = new TraceReader(file.toString(), in, vocabularyOf)) {
      if (!TraceMerge.isOfOneRun(reader.header(), header)) {
        console.accept(file + ": not shown: its header differs from that of the first trace");
        return;
      }
      TraceEvent event = reader.next();
      ProcessFact.Clock clock = clock(event);
      if (clock == null) {
        console.accept(file + ": not shown: it does not name its clock");
        return;
      }
      long startNs = startNs(clock);
      boolean isOfWorld = event != null && event.robot().equals(Fault.WORLD);
      Silence silence = new Silence(reader);
      in.whenWaiting = isOfWorld ? nowNs -> reader.end() != null : silence::look;
      for (; event != null; event = reader.next()) {
        long atNs = startNs + event.timeNs();
        silence.heard(event.robot(), atNs);
        if (ProcessFact.isProcessEvent(event)) {
          merge.reached(atNs);
        } else {
          merge.add(event, atNs, isOfWorld);
        }
      }
    } catch (IOException | BadInput e) {
      if (!isClosed) {
        console.accept(file + ": shown up to here: " + e.getMessage());
      }
    } finally {
      past.tell();
    }
  }

  /** Time 0 of a trace, in the merged run: exact on one machine, else as good as its date. */
  private long startNs(ProcessFact.Clock clock) {
    boolean isOnOneClock =
        clock.machine().equals(origin.machine()) && !clock.machine().equals(MachineClock.UNKNOWN);
    return isOnOneClock ? clock.machineNs() - origin.machineNs() : clock.dateNs() - origin.dateNs();
  }

  /** Ends the reading. */
  @Override
  public void close() {
    isClosed = true;
    closing.countDown();
  }

  /** Whether a trace has told what was in it when it was opened. */
  private final class CaughtUp {
    private boolean hasTold;

    void tell() {
      if (!hasTold) {
        hasTold = true;
        merge.caughtUp();
      }
    }
  }

  /**
   * Whether a robot's process still writes: a killed one leaves a trace without an end. Real time
   * tells, not that of the other traces: all may fall silent, and their clocks may be wrong.
   */
  private final class Silence {
    private final TraceReader reader;
    private RobotId robot = Fault.WORLD;
    private long lastNs;
    private long lastRealNs = realNs.getAsLong();
    private boolean isSilent;

    Silence(TraceReader reader) {
      this.reader = reader;
    }

    void heard(RobotId from, long atNs) {
      robot = from;
      lastNs = atNs;
      lastRealNs = realNs.getAsLong();
      if (isSilent) {
        isSilent = false;
        merge.add(new Fault(atNs, robot, Fault.RESTART, "it writes its trace again"), atNs, false);
      }
    }

    /**
     * All is read that was written until {@code nowNs}.
     *
     * @return whether the trace has ended in order
     */
    boolean look(long nowNs) {
      boolean hasEnded = reader.end() != null;
      long silentNs = nowNs - lastRealNs;
      if (!hasEnded && !isSilent && silentNs >= SILENT_NS + LiveMerge.HELD_NS) {
        isSilent = true;
        long atNs = lastNs + SILENT_NS;
        String why = "its trace has been silent for " + SILENT_NS / Time.NS_PER_S + " s";
        merge.add(new Fault(atNs, robot, Fault.CRASH, why), atNs, false);
        merge.reached(atNs + LiveMerge.HELD_NS); // no other may tell the time
      }
      return hasEnded;
    }
  }

  /** A file whose end is not the end: reading waits for more. */
  private final class Growing extends InputStream {
    private final InputStream file;
    private final CaughtUp past;
    // Gets the time before the last read: what was written after it does not count as silence.
    private LongPredicate whenWaiting = nowNs -> false;

    Growing(InputStream file, CaughtUp past) {
      this.file = file;
      this.past = past;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
      while (true) {
        long nowNs = realNs.getAsLong();
        int count = file.read(into, offset, length);
        if (count >= 0 || isClosed) {
          return count;
        }
        past.tell();
        if (whenWaiting.test(nowNs)) {
          return count;
        }
        pause();
      }
    }

    @Override
    public void close() throws IOException {
      file.close();
    }
  }
}
