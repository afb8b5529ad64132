package org.starl.sim.replay;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.Diagnosis;
import org.starl.sim.RunObservers;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.net.NetStatistics;
import org.starl.sim.world.Collisions;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEnd;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceReader;

/**
 * Shows a trace to observers as if it were a run, without simulation. Monitors check it again, and
 * the observers receive violations. Traces contain no log lines.
 */
public final class TracePlayer {

  private final String file;
  private final TraceReader reader;
  private final RunObservers observers;
  private final Set<RobotId> onFloor = new TreeSet<>();
  private long events;
  private long timeNs;
  private long sent;
  private long sentBytes;
  private long delivered;
  private long dropped;

  private TracePlayer(
      String file,
      TraceReader reader,
      List<Monitor> monitors,
      List<SimObserver> observers,
      Supplier<List<String>> commands) {
    this.file = file;
    this.reader = reader;
    this.observers =
        new RunObservers(new Monitors(monitors), observers, violation -> Diagnosis.NONE, commands);
  }

  /**
   * Shows all remaining events of {@code reader}.
   *
   * @param file name of the trace, for error messages
   * @param monitors new monitors of the specifications to check
   * @param commands for the description of a failure
   * @return the result, without the apps' return values, which are not in a trace
   * @throws IOException if the trace cannot be read, or a line is invalid
   * @throws BadInput if the trace is truncated or inconsistent
   */
  public static SimResult show(
      String file,
      TraceReader reader,
      List<Monitor> monitors,
      List<SimObserver> observers,
      Supplier<List<String>> commands)
      throws IOException {
    return new TracePlayer(file, reader, monitors, observers, commands).show();
  }

  private SimResult show() throws IOException {
    observers.started(reader.header());
    for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
      check(event);
      count(event);
      observers.record(event);
    }
    @Nullable TraceEnd end = reader.end();
    if (end == null) {
      throw new BadInput(
          file + ": no line of kind end: the trace is truncated, or an error ended its run");
    }
    if (end.timeNs() < timeNs) {
      throw bad("an end that is not before the last event");
    }
    SpecReport spec = observers.endSpecifications(end.timeNs());
    SimResult result = result(end.timeNs(), spec, end.unfinished());
    observers.finished(result);
    return result;
  }

  private void check(TraceEvent event) {
    if (event.timeNs() < timeNs) {
      throw bad("a time that is not before the one above");
    }
    timeNs = event.timeNs();
    switch (event) {
      case TraceEvent.Joined joined -> onFloor.add(joined.robot());
      case TraceEvent.Moved moved -> {
        if (!onFloor.contains(moved.robot())) {
          throw bad("a robot that has joined and not left");
        }
      }
      case TraceEvent.Left left -> onFloor.remove(left.robot());
      default -> {
        // Allowed for any robot at any time.
      }
    }
  }

  private BadInput bad(String expected) {
    return new BadInput(file + ":" + reader.lineNumber() + ": expected " + expected);
  }

  private void count(TraceEvent event) {
    events++;
    switch (event) {
      case TraceEvent.Sent message -> {
        sent++;
        sentBytes += message.bytes();
      }
      case TraceEvent.Delivered message -> delivered++;
      case TraceEvent.Dropped message -> dropped++;
      default -> {
        // Not a message.
      }
    }
  }

  private SimResult result(long endNs, SpecReport spec, List<RobotId> unfinished) {
    return new SimResult(
        reader.header().scenarioSeed(),
        reader.header().behaviourSeed(),
        endNs,
        events,
        new TreeMap<>(),
        unfinished,
        new NetStatistics(sent, sentBytes, delivered, dropped),
        Collisions.NONE,
        spec,
        Diagnosis.NONE,
        Map.of(),
        observers.faults(),
        observers.failure(unfinished, Diagnosis.NONE, endNs));
  }
}
