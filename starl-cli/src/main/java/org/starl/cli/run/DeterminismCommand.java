package org.starl.cli.run;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.sim.Simulation;
import org.starl.sim.check.Determinism;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code starl verify-determinism}. */
@Command(
    name = "verify-determinism",
    description =
        "Runs one seed several times, on virtual and on platform threads, and compares the traces."
            + " Prints the first event that differs.",
    footer = {"", "Example: starl verify-determinism intersection --seed 7"})
public final class DeterminismCommand extends BaseCommand implements Callable<Integer> {

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws IOException {
    RunRequest request = options.request(demos());
    long seedNumber = seed.value();
    Determinism check = Determinism.verify(() -> plan(request, seedNumber));
    Determinism.Difference difference = check.difference();
    Map<String, Object> result = new LinkedHashMap<>();
    result.put("app", request.demo().name());
    result.put("seed", seedNumber);
    result.put("runs", check.runs());
    result.put("lines", check.lines());
    result.put("equal", check.holds());
    result.put("difference", difference == null ? "" : difference.toString());
    json.print(
        out(),
        result,
        List.of(
            request.demo().name() + ", seed " + seedNumber + ": " + String.join(", ", check.runs()),
            difference == null
                ? "equal, byte by byte: " + check.lines() + " lines each"
                : difference.toString()));
    return check.holds() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  private Simulation.Builder plan(RunRequest request, long seed) {
    Simulation.Builder simulation = request.plan(seed).simulation();
    RunProgress.of(simulation, this);
    return simulation;
  }
}
