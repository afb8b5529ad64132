package org.starl.cli;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.Determinism;
import org.starl.sim.check.ReplayCheck;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code starl replay}. */
@Command(
    name = "replay",
    description =
        "Shows a trace in a window; or runs its run again, and compares the two line by line.",
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Example: starl replay out/crossing.trace",
      "         starl replay out/crossing.trace --headless",
      "where 'starl run intersection --seed 7 --trace out/crossing.trace' has made the trace."
    })
final class ReplayCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "TRACE", description = "A trace, of 'run --trace'.")
  private String file = "";

  @Option(names = "--headless", description = "Without a window: only check that it replays.")
  private boolean headless;

  @Mixin private Viewing viewing = new Viewing();

  @Mixin private JsonOption json = new JsonOption();

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() {
    CommandSpec command = Objects.requireNonNull(spec);
    TraceFile trace = TraceFile.open(file, Main.demos(command));
    return headless ? check(trace, command.commandLine().getOut()) : show(trace);
  }

  private int check(TraceFile trace, PrintWriter out) {
    ReplayCheck check = trace.replay();
    Determinism.Difference difference = check.difference();
    String failure = check.failure() == null ? "" : "the replay failed: " + check.failure();
    if (json.isOn()) {
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("trace", trace.name());
      result.put("equal", check.isEqual());
      result.put("lines", check.lines());
      result.put("difference", difference == null ? failure : difference.toString());
      out.println(Json.line(result));
    } else {
      out.println(
          trace.name()
              + ": "
              + trace.header().scenario()
              + ", seed "
              + trace.header().scenarioSeed());
      if (!failure.isEmpty()) {
        out.println(failure);
      }
      out.println(
          difference == null ? "equal: " + check.lines() + " lines" : difference.toString());
    }
    return check.isEqual() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  /** Shows what is in the trace; nothing is run. */
  private int show(TraceFile trace) {
    Viewing.demandScreen();
    viewing.show(trace.reading());
    return ExitStatus.GOOD;
  }
}
