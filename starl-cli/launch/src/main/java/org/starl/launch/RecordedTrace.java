package org.starl.launch;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.shape.JsonFormatException;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

/**
 * The trace of one process.
 *
 * @param name its file, or the robot
 * @param robot the traced robot; {@link Fault#WORLD} for the world
 * @param machine the machine whose monotonic clock has these times; unique if unknown
 * @param machineNs that clock's time at the trace's time 0
 * @param dateNs the date at the trace's time 0, in ns since 2020, by that machine
 * @param events without the process's own facts ({@link ProcessFact})
 * @param lastNs the time of the last event
 * @param isComplete whether the process ended in order; else it was killed
 * @param hasTrueBodies whether it has the true positions of bodies; else measured ones
 */
record RecordedTrace(
    String name,
    RobotId robot,
    String machine,
    long machineNs,
    long dateNs,
    TraceHeader header,
    List<TraceEvent> events,
    long lastNs,
    boolean isComplete,
    boolean hasTrueBodies) {

  private static final int BUFFER_BYTES = 1 << 16;
  private static final String EXPECTED = "; expected a trace of 'starl deploy run'";

  RecordedTrace {
    events = List.copyOf(events);
  }

  /**
   * @param vocabularyOf the shapes of the values in a trace with this header
   * @throws BadInput if the file is missing, or is not a trace of a deployment
   */
  static RecordedTrace read(String file, Function<TraceHeader, Vocabulary> vocabularyOf) {
    if (!Files.isRegularFile(Path.of(file))) {
      throw new BadInput(file + ": no such file" + EXPECTED);
    }
    try (InputStream in =
            new BufferedInputStream(Files.newInputStream(Path.of(file)), BUFFER_BYTES);
        TraceReader reader = new TraceReader(file, in, vocabularyOf)) {
      return read(file, reader);
    } catch (IOException e) {
      throw new BadInput(FailureText.of(file, e));
    }
  }

  private static RecordedTrace read(String file, TraceReader reader) throws IOException {
    List<TraceEvent> events = new ArrayList<>();
    Action first = null;
    ProcessFact.Clock clock = null;
    boolean isComplete = false;
    try {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        if (!ProcessFact.isProcessEvent(event)) {
          events.add(event);
        } else if (event instanceof Action action
            && action.fact() instanceof ProcessFact.Clock told) {
          first = action;
          clock = told;
        }
      }
      isComplete = reader.end() != null;
    } catch (JsonFormatException wrong) {
      if (clock == null || !isLast(reader)) {
        throw wrong;
      }
      // The process was killed while it wrote this line: use the lines before it.
    }
    if (clock == null && isMerged(events)) {
      throw new BadInput(
          file + ": is the output of 'starl deploy merge'; expected the traces before it");
    }
    if (clock == null || first == null) {
      throw new BadInput(file + ": does not name its clock" + EXPECTED);
    }
    return new RecordedTrace(
        file,
        first.robot(),
        clock.machine().equals(MachineClock.UNKNOWN) ? file : clock.machine(),
        clock.machineNs(),
        clock.dateNs(),
        reader.header(),
        events,
        events.isEmpty() ? 0 : events.get(events.size() - 1).timeNs(),
        isComplete,
        first.robot().equals(Fault.WORLD));
  }

  /** A merged trace begins with a fault of the world, as {@link TraceMerge} describes. */
  private static boolean isMerged(List<TraceEvent> events) {
    return !events.isEmpty() && events.get(0) instanceof Fault fault && fault.isRealTime();
  }

  /** Whether both are of one start of one process. */
  boolean isSameStart(RecordedTrace other) {
    return robot.equals(other.robot)
        && header.equals(other.header)
        && machineNs == other.machineNs
        && dateNs == other.dateNs;
  }

  /** Which start of its robot it is, from 1, by its file's name: {@code bot0.2.trace}; 0 if unnamed. */
  int start() {
    Matcher numbered =
        Pattern.compile(Pattern.quote(robot.name()) + "(?:\\.(\\d{1,9}))?\\.trace")
            .matcher(String.valueOf(Path.of(name).getFileName()));
    if (!numbered.matches()) {
      return 0;
    }
    return numbered.group(1) == null ? 1 : Integer.parseInt(numbered.group(1));
  }

  /** Whether the line that was read last is the last one, and not after the trace's end. */
  private static boolean isLast(TraceReader reader) throws IOException {
    try {
      return reader.end() == null && reader.next() == null;
    } catch (JsonFormatException another) {
      return false;
    }
  }

  boolean isOfWorld() {
    return robot.equals(Fault.WORLD);
  }
}
