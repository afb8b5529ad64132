package org.starl.cli;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.Version;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.check.ReplayCheck;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.SameInterventions;
import org.starl.sim.replay.TraceReading;
import org.starl.sim.replay.TraceShow;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Intervention;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;

/**
 * A trace in a file, and the run that it is of. All errors are {@link BadInput}: the file is missing, or
 * no trace, or cut off, or of another version, or of an app that is not here.
 */
final class TraceFile {

  private static final int BUFFER_BYTES = 1 << 16;

  private final String name;
  private final TraceHeader header;
  private final RunRequest chosen;

  private TraceFile(String name, TraceHeader header, RunRequest chosen) {
    this.name = name;
    this.header = header;
    this.chosen = chosen;
  }

  /** Whether {@code what} means a trace, not an app or a scenario file. */
  static boolean isOne(String what) {
    return what.endsWith(".trace") || (!ScenarioFile.isOne(what) && isFile(what));
  }

  private static boolean isFile(String what) {
    try {
      return what.contains(".") && Files.isRegularFile(Path.of(what));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  /** Reads the header. */
  static TraceFile open(String name, Demos demos) {
    try (TraceReader reader = reader(name)) {
      TraceHeader header = reader.header();
      if (!header.starl().equals(Version.STARL)) {
        throw new BadInput(
            name
                + ": was written by StarL "
                + BadInput.quote(header.starl())
                + "; expected "
                + Version.STARL
                + ", which this is");
      }
      return new TraceFile(name, header, chosen(name, header, demos));
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private static RunRequest chosen(String name, TraceHeader header, Demos demos) {
    String where = name + ":1: ";
    RunRequest.Builder request = RunRequest.Builder.of(demos, header.scenario(), where, "");
    header.settings().forEach((key, value) -> request.set(where, key, value));
    return request.build();
  }

  String name() {
    return name;
  }

  TraceHeader header() {
    return header;
  }

  /** Its run, a fresh one at each call: ready to be run again, but for what a person did to it. */
  Plan plan() {
    try {
      Plan plan = chosen.plan(header.scenarioSeed());
      plan.simulation().behaviourSeed(header.behaviourSeed());
      return plan;
    } catch (BadInput e) {
      throw new BadInput(name + ":1: " + e.getMessage());
    }
  }

  /** Reads all of it. */
  void requireWhole() {
    show(List.of(), List.of());
  }

  /** Shows it to the observers, and to the monitors of its app; nothing is simulated. */
  SimResult show(List<? extends SimObserver> observers) {
    return show(monitors(), observers);
  }

  private List<Monitor> monitors() {
    return Monitors.of(plan().simulation().build().plan().monitors()).monitors();
  }

  /** Ready to be read for somebody who watches, and checked by the monitors of its app meanwhile. */
  TraceReading reading() {
    Plan plan = plan();
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    return new TraceReading(recording, observers -> show(List.of(), observers), this::monitors);
  }

  private SimResult show(List<Monitor> monitors, List<? extends SimObserver> observers) {
    try (TraceReader reader = reader(name)) {
      return TraceShow.show(name, reader, monitors, List.copyOf(observers));
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  /**
   * Runs it again, with what a person did, and compares.
   *
   * @throws BadInput if its robots were processes as well: then there is no running it again
   */
  ReplayCheck replay() {
    List<Intervention> interventions = new ArrayList<>();
    boolean[] isOfProcesses = new boolean[1];
    SimObserver look =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (event instanceof Intervention intervention) {
              interventions.add(intervention);
            }
            isOfProcesses[0] |= event instanceof TraceEvent.Fault fault && fault.isRealTime();
          }
        };
    show(List.of(), List.of(look));
    if (isOfProcesses[0]) {
      throw new BadInput(
          name
              + ": its robots were processes in real time, which nobody can repeat; expected a trace"
              + " of a simulation ('starl replay' without --headless shows this one)");
    }
    Plan plan = plan();
    if (!interventions.isEmpty()) {
      plan.simulation().bystander(new SameInterventions(interventions));
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(Path.of(name)), 1 << 16)) {
      return ReplayCheck.of(plan.simulation(), in);
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private static TraceReader reader(String name) throws IOException {
    Path path;
    try {
      path = Path.of(name);
    } catch (InvalidPathException e) {
      throw new BadInput(BadInput.quote(name) + ": expected the name of a trace");
    }
    if (!Files.isRegularFile(path)) {
      throw new BadInput(
          name
              + (Files.exists(path) ? ": is no file" : ": there is no such file")
              + "; expected a trace, as 'starl run APP --trace FILE' writes it");
    }
    InputStream in = new BufferedInputStream(Files.newInputStream(path), BUFFER_BYTES);
    try {
      return new TraceReader(name, in);
    } catch (IOException e) {
      in.close();
      throw e;
    }
  }

  private static BadInput unreadable(String name, IOException error) {
    String message = String.valueOf(error.getMessage());
    return new BadInput(message.startsWith(name) ? message : name + ": " + message);
  }
}
