package org.starl.cli.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.request.TraceFile;
import org.starl.sim.check.Determinism;
import org.starl.sim.check.ReplayCheck;
import org.starl.trace.TraceHeader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl replay}. */
@Command(
    name = "replay",
    description =
        "Shows a trace in a window. With --headless, repeats its run and compares the two traces"
            + " line by line.",
    footer = {
      "",
      "Example: starl replay out/crossing.trace",
      "         starl replay out/crossing.trace --headless",
      "To make the trace: starl run intersection --seed 7 --trace out/crossing.trace"
    })
public final class ReplayCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(
      index = "0",
      paramLabel = "TRACE",
      description = "A trace, written by 'starl run --trace'.")
  private String file = "";

  @Option(names = "--headless", description = "Repeat the run and compare, without a window.")
  private boolean headless;

  @Mixin private Viewing viewing = new Viewing();

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() {
    TraceFile trace = TraceFile.open(file, demos());
    return headless ? check(trace) : show(trace);
  }

  private int check(TraceFile trace) {
    ReplayCheck check = trace.replay();
    Determinism.Difference difference = check.difference();
    String failure = check.failure() == null ? "" : "the replay failed: " + check.failure();
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("trace", trace.name());
    result.put("equal", check.isEqual());
    result.put("lines", check.lines());
    result.put("difference", difference == null ? failure : difference.toString());
    List<String> lines = new ArrayList<>();
    TraceHeader header = trace.header();
    lines.add(trace.name() + ": " + header.scenario() + ", seed " + header.scenarioSeed());
    if (!failure.isEmpty()) {
      lines.add(failure);
    }
    lines.add(difference == null ? "equal: " + check.lines() + " lines" : difference.toString());
    json.print(out(), result, lines);
    return check.isEqual() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  /** Shows the trace; simulates nothing. */
  private int show(TraceFile trace) {
    Viewing.requireDisplay();
    viewing.show(trace.reading());
    return ExitStatus.GOOD;
  }
}
