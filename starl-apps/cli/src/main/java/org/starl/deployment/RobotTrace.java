package org.starl.deployment;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.Word;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceFormatException;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;

/**
 * What one process of a deployment has left.
 *
 * @param file its name
 * @param who the robot, or {@link Fault#WORLD}
 * @param machine whose monotonic clock its times are on; no other's if unknown
 * @param machineNs what that clock showed at the trace's time 0
 * @param dateNs the date at the trace's time 0, as ns since 2020, by that machine
 * @param events without what the process says of itself
 * @param isWhole whether the process came to its end; else it was killed
 */
record RobotTrace(
    String file,
    RobotId who,
    String machine,
    long machineNs,
    long dateNs,
    TraceHeader header,
    List<TraceEvent> events,
    boolean isWhole) {

  private static final int BUFFER_BYTES = 1 << 16;

  /** @throws BadInput if there is none, or it is not of a deployment */
  static RobotTrace read(String file) {
    if (!Files.isRegularFile(Path.of(file))) {
      throw new BadInput(file + ": there is no such file; expected a trace of 'starl deploy run'");
    }
    try (InputStream in =
            new BufferedInputStream(Files.newInputStream(Path.of(file)), BUFFER_BYTES);
        TraceReader reader = new TraceReader(file, in)) {
      return read(file, reader);
    } catch (IOException e) {
      String message = String.valueOf(e.getMessage());
      throw new BadInput(message.startsWith(file) ? message : file + ": " + message);
    }
  }

  private static RobotTrace read(String file, TraceReader reader) throws IOException {
    List<TraceEvent> events = new ArrayList<>();
    Action clock = null;
    boolean isWhole = false;
    try {
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        if (!Word.isOne(event)) {
          events.add(event);
        } else if (event instanceof Action action && action.name().equals(Word.CLOCK.name())) {
          clock = action;
        }
      }
      isWhole = reader.end() != null;
    } catch (TraceFormatException wrong) {
      if (clock == null || !isLast(reader)) {
        throw wrong;
      }
      // Killed in the midst of a line: what came before it has happened.
    }
    return of(file, reader.header(), clock, events, isWhole);
  }

  /** Whether nothing follows the line that was read last, nor was before it the trace's end. */
  private static boolean isLast(TraceReader reader) throws IOException {
    try {
      return reader.end() == null && reader.next() == null;
    } catch (TraceFormatException another) {
      return false;
    }
  }

  private static RobotTrace of(
      String file,
      TraceHeader header,
      @Nullable Action clock,
      List<TraceEvent> events,
      boolean isWhole) {
    if (clock == null || clock.args().size() != 3) {
      throw new BadInput(
          file + ": does not say on which clock it is; expected a trace of 'starl deploy run'");
    }
    String machine = clock.args().get(0);
    try {
      return new RobotTrace(
          file,
          clock.robot(),
          machine.equals(MachineClock.UNKNOWN) ? file : machine,
          Long.parseLong(clock.args().get(1)),
          Long.parseLong(clock.args().get(2)),
          header,
          List.copyOf(events),
          isWhole);
    } catch (NumberFormatException e) {
      throw new BadInput(file + ": its clock is " + clock.args() + "; expected numbers");
    }
  }

  boolean isOfWorld() {
    return who.equals(Fault.WORLD);
  }

  /** The time of its last event. */
  long lastNs() {
    return events.isEmpty() ? 0 : events.get(events.size() - 1).timeNs();
  }
}
