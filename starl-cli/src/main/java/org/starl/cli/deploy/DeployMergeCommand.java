package org.starl.cli.deploy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.Shell;
import org.starl.cli.request.TraceFile;
import org.starl.cli.run.ObserverFile;
import org.starl.cli.run.Outcome;
import org.starl.input.Quantities;
import org.starl.launch.TraceMerge;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.sim.TraceRecorder;
import org.starl.time.Time;
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
        TraceMerge.of(
            files,
            header -> TraceFile.vocabulary(files.get(0), header, demos()),
            OptionValues.read("--clock-error", clockError, Quantities::durationNs),
            OptionValues.whole("--drift", drift, 0, 1_000_000));
    Plan plan = TraceFile.open(files.get(0), demos()).plan();
    List<String> show =
        out == null ? List.of() : List.of("show: " + Shell.starl(List.of("replay", out)));
    SimulationPlan simulation = plan.simulation().commands(() -> show).build().plan();
    TraceMerge.Result result;
    try (ObserverFile file = ObserverFile.of("--out", out, TraceRecorder::new)) {
      List<SimObserver> observers = new ArrayList<>(simulation.observers());
      observers.add(file.observer());
      result = merge.judge(simulation, observers);
    }
    List<String> lines = new ArrayList<>(plan.story().lines());
    addLines(lines, result);
    json.print(out(), json(result), lines);
    if (!result.missing().isEmpty()) {
      result.missing().forEach(line -> err().println("starl: " + line));
      return ExitStatus.BAD_INPUT;
    }
    return result.violations().isEmpty() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  private static void addLines(List<String> lines, TraceMerge.Result result) {
    String clocks =
        result.orders() == 1
            ? "all on one clock"
            : "%s orders tried, clocks uncertain by %s"
                .formatted(result.orders(), Quantities.durationText(result.uncertaintyNs()));
    lines.add(
        "%s robots, %s events in %s, %s datagrams; %s"
            .formatted(
                result.robots().size(),
                result.run().events(),
                Time.text(result.run().endNs(), 1),
                result.run().network().sent(),
                clocks));
    if (result.withinMm() > 0) {
      lines.add(
          ("bodies are measured, within %s mm: also tried smaller, larger and shifted to each side"
                  + " by this distance")
              .formatted(Math.round(result.withinMm())));
    }
    result
        .lostMs()
        .forEach((robot, ms) ->
            lines.add(
                "%s was not measured for up to %s ms: a collision in such a gap is not seen"
                    .formatted(robot, Math.round(ms))));
    result
        .dead()
        .forEach(robot ->
            lines.add("%s's trace is incomplete: its process was killed".formatted(robot)));
    add(lines, "VIOLATED: ", result.violations());
    Failure failure = result.failure();
    if (failure != null) {
      failure.reasons().forEach(line -> lines.add("  " + line));
    }
    String unsure =
        result.missing().isEmpty()
            ? "within the errors of clocks and measurements"
            : "traces are missing";
    add(lines, "possible, " + unsure + ": ", result.possible());
    if (result.missing().isEmpty() && result.violations().isEmpty()) {
      Set<String> undecided = result.undecided();
      String held = Outcome.held(result.run().spec(), undecided);
      if (undecided.isEmpty()) {
        lines.add("safe: " + held);
      } else {
        lines.add(held);
        lines.add("not decided: " + String.join(" ", undecided) + "; no violation is certain");
      }
      lines.addAll(Outcome.unknown(result.run().spec()));
    }
  }

  private static void add(List<String> lines, String words, Collection<?> violations) {
    violations.stream().limit(SHOWN).forEach(violation -> lines.add(words + violation));
  }

  private static Map<String, Object> json(TraceMerge.Result result) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("good", result.violations().isEmpty() && result.missing().isEmpty());
    json.put("robots", result.robots().stream().map(String::valueOf).toList());
    json.put("dead", result.dead().stream().map(String::valueOf).toList());
    json.put("events", result.run().events());
    json.put("orders", result.orders());
    json.put("uncertainty_ns", result.uncertaintyNs());
    json.put("bodies_within_mm", Math.round(result.withinMm()));
    json.put("missing", result.missing());
    json.put("violations", result.violations().stream().map(String::valueOf).toList());
    Failure failure = result.failure();
    if (failure != null) {
      json.put("failure", failure.fields());
    }
    json.put("possible", result.possible().stream().map(String::valueOf).toList());
    json.put("not_decided", result.undecided());
    return json;
  }
}
