package org.starl.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.launch.TraceMerge;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.sim.TraceRecorder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl deploy merge}. */
@Command(
    name = "merge",
    description =
        "Merges the traces of a deployment's processes into one trace in causal order, and checks"
            + " the app's specifications. Clock errors allow several orders of events, and"
            + " measurement errors several places of bodies. A violation in all tried cases is"
            + " reported as VIOLATED, a violation in only some of them as possible.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl deploy merge bot*.trace --out merged.trace"})
final class DeployMergeCommand extends BaseCommand implements Callable<Integer> {

  private static final int SHOWN = 20;

  @Parameters(
      arity = "1..*",
      paramLabel = "TRACE",
      description = "Traces of 'deploy run' and 'deploy world'.")
  private List<String> files = new ArrayList<>();

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Write the merged trace to FILE, for 'starl replay'.")
  private @Nullable String out;

  @Option(
      names = "--clock-error",
      paramLabel = "TIME",
      defaultValue = "1s",
      description = "The largest error of a machine's date (default: ${DEFAULT-VALUE}).")
  private String clockError = "1s";

  @Option(
      names = "--drift",
      paramLabel = "PPM",
      defaultValue = "100",
      description =
          "The largest drift between two clocks, in parts per million (default: ${DEFAULT-VALUE}).")
  private String drift = "100";

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws IOException {
    TraceMerge merge =
        TraceMerge.of(files, durationNs(), Numbers.whole("--drift", drift, 0, 1_000_000));
    Plan plan = TraceFile.open(files.get(0), demos()).plan();
    SimulationPlan blueprint = plan.simulation().build().plan();
    TraceMerge.Result result;
    try (ObserverFile file = ObserverFile.of("--out", out, TraceRecorder::new)) {
      List<SimObserver> observers = new ArrayList<>(blueprint.observers());
      observers.add(file.observer());
      result = merge.judge(blueprint, observers);
    }
    List<String> lines = new ArrayList<>(plan.story().lines());
    lines.addAll(lines(result));
    json.print(out(), json(result), lines);
    return result.violations().isEmpty() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  private long durationNs() {
    try {
      return Quantities.durationNs(clockError);
    } catch (BadInput error) {
      throw Quantities.in("--clock-error", error);
    }
  }

  private static List<String> lines(TraceMerge.Result result) {
    List<String> lines = new ArrayList<>();
    lines.add(
        result.robots().size()
            + " robots, "
            + result.run().events()
            + " events in "
            + Outcome.seconds(result.run().endNs())
            + ", "
            + result.run().network().sent()
            + " datagrams; "
            + (result.orders() == 1
                ? "all on one clock"
                : result.orders()
                    + " orders tried, clocks uncertain by "
                    + Quantities.durationText(result.uncertaintyNs())));
    if (result.withinMm() > 0) {
      lines.add(
          "bodies are measured, within "
              + Math.round(result.withinMm())
              + " mm: also tried smaller, larger and shifted to each side by this distance");
    }
    result
        .lostMs()
        .forEach((robot, ms) ->
            lines.add(
                robot
                    + " was not measured for up to "
                    + Math.round(ms)
                    + " ms: a collision in such a gap is not seen"));
    result
        .dead()
        .forEach(robot -> lines.add(robot + "'s trace is incomplete: its process was killed"));
    result.violations().stream()
        .limit(SHOWN)
        .forEach(violation -> lines.add("VIOLATED: " + violation));
    result.possible().stream()
        .limit(SHOWN)
        .forEach(violation ->
            lines.add("possible, within the errors of clocks and measurements: " + violation));
    if (result.violations().isEmpty() && result.possible().isEmpty()) {
      lines.add("safe: " + Outcome.held(result.run().spec()));
    }
    return lines;
  }

  private static Map<String, Object> json(TraceMerge.Result result) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("good", result.violations().isEmpty());
    json.put("robots", result.robots().stream().map(String::valueOf).toList());
    json.put("dead", result.dead().stream().map(String::valueOf).toList());
    json.put("events", result.run().events());
    json.put("orders", result.orders());
    json.put("uncertainty_ns", result.uncertaintyNs());
    json.put("bodies_within_mm", Math.round(result.withinMm()));
    json.put("violations", result.violations().stream().map(String::valueOf).toList());
    json.put("possible", result.possible().stream().map(String::valueOf).toList());
    return json;
  }
}
