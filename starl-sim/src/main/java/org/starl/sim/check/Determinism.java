package org.starl.sim.check;

import java.io.BufferedInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;
import org.starl.sim.TraceRecorder;
import org.starl.sim.kernel.CarrierKind;

/**
 * Checks that a simulation depends only on its seeds and settings: runs it twice, on both kinds of
 * carriers if this Java supports both, and compares the traces byte by byte.
 *
 * @param runs descriptions of the runs, in order
 * @param lines of the first run's trace, its header and its outcome included
 * @param difference the first difference, or null if all runs were equal
 */
public record Determinism(List<String> runs, long lines, @Nullable Difference difference) {

  private static final Pattern PLACE =
      Pattern.compile("\"timeNs\":(\\d+)(?:,\"robot\":\"([^\"]+)\")?");
  private static final int WHOLE_SECOND_DIGITS = 9;

  /**
   * The first line that differs between two runs: a line of the trace, or the outcome after it.
   *
   * @param line its number in the trace, from 1
   */
  public record Difference(
      String firstRun, String secondRun, long line, String firstLine, String secondLine) {

    /** Three lines: the position, and the text of each run. */
    @Override
    public String toString() {
      String place = place(firstLine);
      return "first difference at line "
          + line
          + (place.isEmpty() ? place(secondLine) : place)
          + "\n  "
          + firstRun
          + ": "
          + firstLine
          + "\n  "
          + secondRun
          + ": "
          + secondLine;
    }

    private static String place(String text) {
      Matcher matcher = PLACE.matcher(text);
      if (!matcher.find()) {
        return "";
      }
      String digits = "0".repeat(WHOLE_SECOND_DIGITS) + matcher.group(1);
      int point = digits.length() - WHOLE_SECOND_DIGITS;
      String seconds = digits.substring(0, point).replaceFirst("^0+(?=.)", "");
      String robot = matcher.group(2) == null ? "" : ", " + matcher.group(2);
      return " (" + seconds + "." + digits.substring(point) + " s" + robot + ")";
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
    List<String> done = new ArrayList<>();
    Path reference = Files.createTempFile("starl-determinism", ".trace");
    try {
      long lines;
      try (OutputStream out = Files.newOutputStream(reference)) {
        LineCounter counter = new LineCounter(out);
        run(scenario, plan.get(0), counter);
        lines = counter.lines;
      }
      done.add(plan.get(0).name());
      for (Planned next : plan.subList(1, plan.size())) {
        done.add(next.name());
        LineComparer.DifferentLines found = compare(scenario, next, reference);
        if (found != null) {
          Difference difference =
              new Difference(
                  done.get(0), next.name(), found.line(), found.reference(), found.written());
          return new Determinism(done, lines, difference);
        }
      }
      return new Determinism(done, lines, null);
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

  private static LineComparer.@Nullable DifferentLines compare(
      Supplier<Simulation.Builder> scenario, Planned run, Path reference) throws IOException {
    try (InputStream in = new BufferedInputStream(Files.newInputStream(reference), 1 << 16)) {
      LineComparer comparer = new LineComparer(in);
      run(scenario, run, comparer);
      return comparer.difference();
    }
  }

  /** Writes the trace to {@code out}, then one line with the outcome. */
  private static void run(Supplier<Simulation.Builder> scenario, Planned run, OutputStream out)
      throws IOException {
    String outcome;
    try (TraceRecorder recorder = new TraceRecorder(new NotClosing(out))) {
      SimResult result = scenario.get().carriers(run.carriers()).observer(recorder).build().run();
      outcome =
          "outcome: "
              + result.events()
              + " kernel events, unfinished "
              + result.unfinished()
              + ", "
              + result.network();
    } catch (SimulationFailed e) {
      outcome = "outcome: " + e.getMessage();
    }
    out.write((outcome + "\n").getBytes(StandardCharsets.UTF_8));
  }

  /** Prevents the recorder from closing the underlying stream. */
  private static final class NotClosing extends FilterOutputStream {
    NotClosing(OutputStream out) {
      super(out);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
      out.write(bytes, from, length);
    }

    @Override
    public void close() throws IOException {
      flush();
    }
  }

  private static final class LineCounter extends FilterOutputStream {
    private long lines;

    LineCounter(OutputStream out) {
      super(out);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
      for (int i = from; i < from + length; i++) {
        lines += bytes[i] == '\n' ? 1 : 0;
      }
      out.write(bytes, from, length);
    }
  }
}
