package org.starl.cli.request;

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
import org.starl.cli.command.Shell;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.robot.DeployedRobot;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.check.ReplayCheck;
import org.starl.sim.replay.InterventionReplayer;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceLoader;
import org.starl.sim.replay.TracePlayer;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Intervention;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

/**
 * A trace file and its run. Every error is {@link BadInput}: the file is missing, is not a trace,
 * is incomplete, or has another version or an unknown app.
 */
public final class TraceFile {

  private static final int BUFFER_BYTES = 1 << 16;

  private final String name;
  private final TraceHeader header;
  private final RunRequest request;

  private TraceFile(String name, TraceHeader header, RunRequest request) {
    this.name = name;
    this.header = header;
    this.request = request;
  }

  /** Whether {@code name} is that of a trace, not an app or a scenario file. */
  public static boolean isTrace(String name) {
    return name.endsWith(".trace") || (!ScenarioFile.isScenario(name) && isFile(name));
  }

  private static boolean isFile(String name) {
    try {
      return name.contains(".") && Files.isRegularFile(Path.of(name));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  /** Reads the header. */
  public static TraceFile open(String name, Demos demos) {
    try (TraceReader reader = reader(name, Vocabulary.NONE)) {
      TraceHeader header = reader.header();
      if (!header.starl().equals(Version.STARL)) {
        throw new BadInput(
            "%s: was written by StarL %s; expected this version, %s"
                .formatted(name, BadInput.quote(header.starl()), Version.STARL));
      }
      return new TraceFile(name, header, request(name, header, demos));
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private static RunRequest request(String name, TraceHeader header, Demos demos) {
    String where = name + ":1: ";
    RunRequest.Builder request = RunRequest.Builder.of(demos, header.scenario(), where, "");
    header.settings().forEach((key, value) -> request.set(where, key, value));
    return request.build();
  }

  public String name() {
    return name;
  }

  public TraceHeader header() {
    return header;
  }

  /** The request of its run, without the user's interventions. */
  public RunRequest request() {
    return request;
  }

  /** The plan of its run, a new one at each call, without the user's interventions. */
  public Plan plan() {
    try {
      Plan plan = request.plan(header.scenarioSeed());
      plan.simulation().behaviourSeed(header.behaviourSeed());
      return plan;
    } catch (BadInput e) {
      throw new BadInput(name + ":1: " + e.getMessage());
    }
  }

  /** Reads the whole trace to check that it is complete. */
  public void requireWhole() {
    show(List.of(), List.of());
  }

  /** Shows the trace to the observers and to the app's monitors; simulates nothing. */
  public SimResult show(List<? extends SimObserver> observers) {
    return show(monitors(), observers);
  }

  private List<Monitor> monitors() {
    return Monitors.of(plan().simulation().build().plan().monitors()).monitors();
  }

  /** A reading for the viewer; the app's monitors check it meanwhile. */
  public TraceLoader reading() {
    Plan plan = plan();
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    return new TraceLoader(
        recording, observers -> show(List.of(), observers), this::monitors, this::commands);
  }

  private Vocabulary vocabulary() {
    return request.vocabulary(header.scenarioSeed()).and(DeployedRobot.VOCABULARY);
  }

  /** The shapes of the values in the trace {@code name} with this header. */
  public static Vocabulary vocabulary(String name, TraceHeader header, Demos demos) {
    return new TraceFile(name, header, request(name, header, demos)).vocabulary();
  }

  private SimResult show(List<Monitor> monitors, List<? extends SimObserver> observers) {
    try (TraceReader reader = reader(name, vocabulary())) {
      return TracePlayer.show(name, reader, monitors, List.copyOf(observers), this::commands);
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  /**
   * Repeats the run, with the user's interventions, and compares the traces.
   *
   * @throws BadInput if its robots were processes: such a run cannot be repeated
   */
  public ReplayCheck replay() {
    Plan plan = plan();
    List<Intervention> interventions = interventions();
    if (!interventions.isEmpty()) {
      plan.simulation().stepListener(new InterventionReplayer(interventions));
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(Path.of(name)), 1 << 16)) {
      return ReplayCheck.of(plan.simulation(), in);
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private List<String> commands() {
    return List.of((isOfProcesses() ? "show: " : "replay: ") + again());
  }

  /** The command that compares the trace with its run, repeated; of processes, that shows it. */
  public String again() {
    List<String> words = new ArrayList<>(List.of("replay", name));
    if (!isOfProcesses()) {
      words.add("--headless");
    }
    return Shell.starl(words);
  }

  /** Whether its robots were processes in real time: its first event says so. */
  private boolean isOfProcesses() {
    try (TraceReader reader = reader(name, vocabulary())) {
      return reader.next() instanceof TraceEvent.Fault fault && fault.isRealTime();
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  /**
   * @throws BadInput unless the header alone makes the run again
   */
  public void requireRepeatable() {
    if (!interventions().isEmpty()) {
      throw new BadInput(name + ": a person changed its run; expected a run without interventions");
    }
  }

  /**
   * The user's interventions in its run.
   *
   * @throws BadInput if its robots were processes: such a run cannot be repeated
   */
  private List<Intervention> interventions() {
    List<Intervention> interventions = new ArrayList<>();
    SimObserver finder =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            if (event instanceof Intervention intervention) {
              interventions.add(intervention);
            }
          }
        };
    show(List.of(), List.of(finder));
    if (isOfProcesses()) {
      throw new BadInput(
          name
              + ": its robots were processes in real time, so it cannot be repeated; expected a"
              + " trace of a simulation ('starl replay' without --headless shows this one)");
    }
    return interventions;
  }

  private static TraceReader reader(String name, Vocabulary vocabulary) throws IOException {
    Path path;
    try {
      path = Path.of(name);
    } catch (InvalidPathException e) {
      throw new BadInput(BadInput.quote(name) + ": expected the name of a trace");
    }
    if (!Files.isRegularFile(path)) {
      String problem = Files.exists(path) ? ": is not a file" : ": no such file";
      throw new BadInput(
          name + problem + "; expected a trace, written by 'starl run APP --trace FILE'");
    }
    InputStream in = new BufferedInputStream(Files.newInputStream(path), BUFFER_BYTES);
    try {
      return new TraceReader(name, in, vocabulary);
    } catch (IOException e) {
      in.close();
      throw e;
    }
  }

  private static BadInput unreadable(String name, IOException error) {
    return new BadInput(FailureText.of(name, error));
  }
}
