package org.starl.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.sim.Simulation;
import org.starl.sim.check.Determinism;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code starl verify-determinism}. */
@Command(
    name = "verify-determinism",
    description = "Runs twice and on both carriers; tells the first event that differs.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl verify-determinism intersection --seed 7"})
final class DeterminismCommand implements Callable<Integer> {

  @Mixin private RunOptions options = new RunOptions();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private JsonOption json = new JsonOption();

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    RunRequest chosen = options.chosen(Main.demos(spec));
    long seedNumber = seed.value();
    PrintWriter err = spec.commandLine().getErr();
    Determinism check = Determinism.verify(() -> plan(chosen, seedNumber, err));
    Determinism.Difference difference = check.difference();
    if (json.isOn()) {
      Map<String, Object> result = new LinkedHashMap<>();
      result.put("app", chosen.demo().name());
      result.put("seed", seedNumber);
      result.put("runs", check.runs());
      result.put("lines", check.lines());
      result.put("equal", check.holds());
      result.put("difference", difference == null ? "" : difference.toString());
      out.println(Json.line(result));
    } else {
      out.println(
          chosen.demo().name() + ", seed " + seedNumber + ": " + String.join(", ", check.runs()));
      out.println(
          difference == null
              ? "equal, byte by byte: " + check.lines() + " lines each"
              : difference.toString());
    }
    return check.holds() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  private static Simulation.Builder plan(RunRequest chosen, long seed, PrintWriter err) {
    Simulation.Builder simulation = chosen.plan(seed).simulation();
    RunProgress.of(simulation, err);
    return simulation;
  }
}
