package org.starl.sim.check;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.sim.TraceRecorder;
import org.starl.sim.kernel.CarrierKind;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * Checks that a simulation depends only on its seeds and settings: runs it twice, on both kinds of
 * carriers if this Java supports both, and compares the traces byte by byte.
 *
 * @param runs descriptions of the runs, in order
 * @param lines of the first run's trace, its header and its outcome included
 * @param difference the first difference, or null if all runs were equal
 */
public record Determinism(List<String> runs, long lines, @Nullable Difference difference) {

  /**
   * The first line that differs between two runs: a line of the trace, or the outcome after it.
   *
   * @param line its number in the trace, from 1
   * @param event the event of the second run's line; null if that is another line, or none
   */
  public record Difference(
      String firstRun,
      String secondRun,
      long line,
      String firstLine,
      String secondLine,
      @Nullable TraceEvent event) {

    /** Three lines: the position, and the text of each run. */
    @Override
    public String toString() {
      return "first difference at line %s%s\n  %s: %s\n  %s: %s"
          .formatted(
              line,
              event == null ? "" : " (" + Time.text(event.timeNs(), 9) + ", " + event.robot() + ")",
              firstRun,
              firstLine,
              secondRun,
              secondLine);
    }
  }

  public Determinism {
    runs = List.copyOf(runs);
  }

  /** Whether all runs were equal. */
  public boolean holds() {
    return difference == null;
  }

  private record Planned(String name, CarrierKind carriers) {}

  /**
   * Executes and compares the runs. Failed runs are compared too: they must fail in the same way.
   *
   * @param scenario returns a new builder of the same simulation at each call
   * @throws IOException if the temporary file of the first trace cannot be written
   */
  public static Determinism verify(Supplier<Simulation.Builder> scenario) throws IOException {
    List<Planned> plan = plan();
    String first = plan.get(0).name();
    List<String> done = new ArrayList<>(List.of(first));
    Path reference = Files.createTempFile("starl-determinism", ".trace");
    try {
      String outcome = run(scenario, plan.get(0), Files.newOutputStream(reference));
      Files.writeString(reference, outcome, StandardOpenOption.APPEND);
      Difference difference = null;
      for (int i = 1; i < plan.size() && difference == null; i++) {
        done.add(plan.get(i).name());
        difference = compare(scenario, plan.get(i), reference, first);
      }
      try (Stream<String> lines = Files.lines(reference)) {
        return new Determinism(done, lines.count(), difference);
      }
    } finally {
      Files.delete(reference);
    }
  }

  private static List<Planned> plan() {
    Planned platform = new Planned("platform threads", CarrierKind.PLATFORM);
    if (CarrierKind.best() == CarrierKind.PLATFORM) {
      return List.of(platform, new Planned("platform threads again", CarrierKind.PLATFORM));
    }
    return List.of(
        new Planned("virtual threads", CarrierKind.VIRTUAL),
        new Planned("virtual threads again", CarrierKind.VIRTUAL),
        platform);
  }

  private static @Nullable Difference compare(
      Supplier<Simulation.Builder> scenario, Planned run, Path reference, String first)
      throws IOException {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(reference), 1 << 16)) {
      LineComparer comparer = new LineComparer(in);
      Supplier<Simulation.Builder> observed = () -> scenario.get().observer(comparer);
      comparer.write(run(observed, run, comparer).getBytes(StandardCharsets.UTF_8));
      return comparer.difference(first, run.name());
    }
  }

  /** Writes the trace to {@code out}, which it closes; returns one line with the outcome. */
  private static String run(Supplier<Simulation.Builder> scenario, Planned run, OutputStream out)
      throws IOException {
    try (TraceRecorder recorder = new TraceRecorder(out)) {
      SimResult result = scenario.get().carriers(run.carriers()).observer(recorder).build().run();
      return "outcome: %s kernel events, unfinished %s, %s\n"
          .formatted(result.events(), result.unfinished(), result.network());
    } catch (SimulationFailed e) {
      return "outcome: " + e.getMessage() + "\n";
    }
  }
}
