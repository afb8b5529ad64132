package org.starl.cli.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;
import org.starl.apps.Plan;
import org.starl.apps.Product;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OutputFile;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.input.BadInput;
import org.starl.launch.LaunchResult;
import org.starl.proof.RunTheories;
import org.starl.sim.SimResult;
import org.starl.sim.TraceRecorder;
import org.starl.sim.export.CsvTable;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.record.PictureTime;
import org.starl.trace.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl run}. */
@Command(
    name = "run",
    description =
        "Runs an app or a primitive once, and checks its specifications. Prints its story and draws a picture.",
    footer = {
      "",
      "Example: starl run intersection --robots 8 --seed 7 --loss 0.1",
      "         starl run search --seed 7 --view",
      "         starl run intersection --seed 7 --pvs run.pvs && pvs/check run.pvs"
    })
public final class RunCommand extends BaseCommand implements Callable<Integer> {

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private SpecsOption specs = new SpecsOption();

  @Option(names = "--trace", paramLabel = "FILE", description = "Write every event to FILE.")
  private @Nullable String trace;

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Write every change of the true motion to FILE, as a table.")
  private @Nullable String csv;

  @Option(
      names = "--csv-messages",
      paramLabel = "FILE",
      description = "Write every message sent, delivered or dropped to FILE, as a table.")
  private @Nullable String csvMessages;

  @Option(
      names = "--csv-variables",
      paramLabel = "FILE",
      description = "Write every new value of a variable to FILE, as a table.")
  private @Nullable String csvVariables;

  @Option(
      names = "--pvs",
      paramLabel = "FILE",
      description =
          "Write the run to FILE as PVS theories. pvs/check proves their obligations, unless a"
              + " primitive did a step that its theory in pvs/ does not allow.")
  private @Nullable String pvs;

  @Option(
      names = "--png",
      paramLabel = "FILE",
      description =
          "Write the picture to FILE (default: out/APP-SEED.png; with settings, a number that"
              + " depends on them follows SEED).")
  private @Nullable String png;

  @Option(
      names = "--result",
      paramLabel = "NAME",
      description = "Write the result files of the app, if it has any: NAME.svg, NAME.png.")
  private @Nullable String result;

  @Option(
      names = "--carrier",
      paramLabel = "KIND",
      description =
          "Thread type for blocking apps, virtual or platform (default: virtual where possible).")
  private @Nullable CarrierKind carrier;

  @Option(
      names = "--explain",
      description = "Also print what each specification says, and how often it was checked.")
  private boolean explain;

  @Option(
      names = "--view",
      description = "Show the run in a window; closing the window ends the run.")
  private boolean view;

  @Mixin private Viewing viewing = new Viewing();

  @Mixin private ProcessOptions processes = new ProcessOptions();

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws IOException {
    if (view && processes.areOn()) {
      throw new BadInput(
          "--view cannot be used with --processes: robots as processes have no window");
    }
    if (processes.areOn()) {
      specs.requireNoneFor("--processes: each process checks its own robot");
    }
    if (view) {
      Viewing.requireDisplay();
    }
    RunRequest request = options.request(demos());
    long seedNumber = seed.value();
    Plan plan = request.plan(seedNumber);
    specs.apply(plan.simulation());
    request.unusedRobots(seedNumber).ifPresent(err()::println);
    String app = request.demo().name();
    if (result != null && plan.story().products().isEmpty()) {
      throw new BadInput("--result cannot be used with " + app + ": it writes no result files");
    }
    String pictureName = png == null ? request.file(seedNumber, "png") : png;
    List<String> again =
        processes.areOn()
            ? List.of(processes.again(request.replay(seedNumber)))
            : request.commands(seedNumber);
    if (processes.areOn()) {
      plan.simulation().commands(() -> again);
    }
    Ran ran;
    try {
      ran = run(app, plan, pictureName, request.words(seedNumber), request.vocabulary(seedNumber));
    } catch (BadInput e) {
      throw e;
    } catch (RuntimeException e) {
      again.forEach(err()::println);
      throw e;
    }
    List<String> lines = new ArrayList<>(List.of(app + ", seed " + seedNumber));
    lines.addAll(plan.story().lines());
    lines.addAll(ran.lines());
    lines.add("picture: " + pictureName);
    ran.json().put("picture", pictureName);
    lines.addAll(writeProducts(plan));
    json.print(out(), ran.json(), lines);
    if (ran.isGood()) {
      return ExitStatus.GOOD;
    }
    again.forEach(err()::println);
    return ExitStatus.VIOLATED;
  }

  /** Writes the result files, if requested; returns a line for each. */
  private List<String> writeProducts(Plan plan) throws IOException {
    List<String> lines = new ArrayList<>();
    for (Product product : result == null ? List.<Product>of() : plan.story().products()) {
      String name = result + product.ending();
      try (OutputFile file = new OutputFile("--result", name)) {
        product.content().write(file.stream());
      }
      lines.add("result: " + name);
    }
    return lines;
  }

  /** The result of a run, simulated or as processes, for output. */
  private record Ran(List<String> lines, Map<String, Object> json, boolean isGood) {

    static Ran simulated(
        String app, SimResult result, Measures measures, boolean isStopped, boolean explain) {
      List<String> lines = new ArrayList<>(Outcome.lines(result, measures));
      if (explain) {
        lines.addAll(Outcome.explanations(result.spec()));
      }
      if (isStopped) {
        lines.add("stopped: the window was closed");
      }
      return new Ran(
          lines,
          Outcome.json(app, result, measures),
          isStopped ? result.spec().holds() : Outcome.isGood(result));
    }

    static Ran processes(String app, LaunchResult result, Measures measures) {
      return new Ran(
          ProcessOutcome.lines(result),
          ProcessOutcome.json(app, result, measures),
          result.isGood());
    }
  }

  /** Runs the plan. The requested files are written even if the run fails. */
  private Ran run(
      String app, Plan plan, String pictureName, List<String> words, Vocabulary vocabulary)
      throws IOException {
    try (ObserverFile traceFile = ObserverFile.of("--trace", trace, TraceRecorder::new);
        ObserverFile csvFile = ObserverFile.of("--csv", csv, CsvTable::positions);
        ObserverFile messages = ObserverFile.of("--csv-messages", csvMessages, CsvTable::messages);
        ObserverFile variables =
            ObserverFile.of("--csv-variables", csvVariables, CsvTable::variables);
        ObserverFile theories = ObserverFile.of("--pvs", pvs, RunTheories::new);
        ObserverFile picture =
            ObserverFile.picture("--png", pictureName, plan, new PictureTime.Best())) {
      plan.simulation()
          .observer(traceFile.observer())
          .observer(csvFile.observer())
          .observer(messages.observer())
          .observer(variables.observer())
          .observer(theories.observer())
          .observer(picture.observer());
      if (processes.areOn()) {
        LaunchResult launched =
            processes.run(plan.simulation().build().plan(), words, vocabulary, null, err());
        return Ran.processes(app, launched, plan.story().measures());
      }
      plan.simulation().carriers(Carriers.select(carrier, err()));
      if (view) {
        Viewing.Watched watched = viewing.run(plan);
        return Ran.simulated(
            app, watched.result(), plan.story().measures(), watched.isStopped(), explain);
      }
      RunProgress progress = RunProgress.of(plan.simulation(), this);
      try {
        SimResult simulated = plan.simulation().build().run();
        return Ran.simulated(app, simulated, plan.story().measures(), false, explain);
      } finally {
        progress.end();
      }
    }
  }
}
