package org.starl.cli.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OutputFile;
import org.starl.cli.command.Shell;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.cli.request.TraceFile;
import org.starl.input.BadInput;
import org.starl.sim.SimulationFailed;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.ComparePage;
import org.starl.sim.view.page.ComparePage.Difference;
import org.starl.sim.view.page.ComparePage.Run;
import org.starl.time.Time;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/** {@code starl compare}. */
@Command(
    name = "compare",
    description =
        "Compares two runs: prints the first event that differs, and writes a page with both, side by"
            + " side and on one clock. A run is a trace, or the words of 'starl run' in quotes.",
    footer = {
      "",
      "Example: starl compare good.trace bad.trace --html both.html",
      "         starl compare 'mutex --seed 5' 'mutex --seed 5 --loss 0.1' --html both.html"
    })
public final class CompareCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(
      index = "0",
      paramLabel = "A",
      description = "A trace, or a run: its app, its seed and its options in quotes.")
  private String first = "";

  @Parameters(index = "1", paramLabel = "B", description = "Another one.")
  private String second = "";

  @Option(names = "--html", paramLabel = "FILE", description = "Write the page to FILE.")
  private @Nullable String html;

  @Mixin private JsonOption json = new JsonOption();

  /** The words of a run. */
  @Command
  private static final class Words {
    @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();
    @Mixin private SeedOption seed = new SeedOption();
  }

  /** A run that has not been shown to its recording. */
  private record Prepared(String command, Recording recording, Runnable work) {

    Run run() {
      work.run();
      return new Run(command, recording);
    }
  }

  @Override
  public Integer call() throws IOException {
    Prepared a = prepared("A", first);
    Prepared b = prepared("B", second);
    if (html == null) {
      return compare(a.run(), b.run(), null);
    }
    OutputFile.requireEnding("--html", html, "html");
    try (OutputFile file = new OutputFile("--html", html)) {
      return compare(a.run(), b.run(), file);
    }
  }

  private int compare(Run a, Run b, @Nullable OutputFile file) throws IOException {
    Difference difference = Difference.of(a.recording(), b.recording());
    List<String> lines = new ArrayList<>(List.of("A: " + a.summary(), "B: " + b.summary()));
    Map<String, Object> result =
        Json.object("a", a.summary(), "b", b.summary(), "equal", difference == null);
    if (difference == null) {
      lines.add("equal: " + a.recording().size() + " events");
    } else {
      lines.add(
          "first difference at %s, event %s"
              .formatted(Time.text(difference.atNs(), 9), difference.index() + 1));
      lines.add("  A: " + Difference.shown(difference.first()));
      lines.add("  B: " + Difference.shown(difference.second()));
      result.put("difference_s", Time.seconds(difference.atNs()));
      result.put("event", difference.index() + 1);
      result.put("a_event", Difference.line(difference.first()));
      result.put("b_event", Difference.line(difference.second()));
    }
    if (file != null) {
      new ComparePage(a, b, difference).write(file.stream());
      lines.add("page: " + html);
    }
    json.print(out(), result, lines);
    return ExitStatus.GOOD;
  }

  private Prepared prepared(String name, String text) {
    if (TraceFile.isTrace(text)) {
      TraceFile trace = TraceFile.open(text, demos());
      trace.requireWhole();
      Recording recording = Viewing.recording(trace.plan());
      String command = Shell.starl(List.of("replay", text));
      return new Prepared(command, recording, () -> trace.show(List.of(recording)));
    }
    try {
      return simulated(words(text));
    } catch (ParameterException | BadInput e) {
      throw new BadInput(name + ": " + BadInput.quote(text) + ": " + e.getMessage());
    }
  }

  private Prepared simulated(Words words) {
    RunRequest request = words.options.request(demos());
    long seed = words.seed.value();
    Plan plan = request.plan(seed);
    plan.simulation().build();
    Recording recording = Viewing.recording(plan);
    Plan own = request.plan(seed);
    own.simulation().carriers(Carriers.select(null, err())).observer(recording);
    return new Prepared(
        request.replay(seed),
        recording,
        () -> {
          try {
            own.simulation().build().run();
          } catch (SimulationFailed e) {
            recording.failed(String.valueOf(e.getMessage()));
          }
        });
  }

  /** The words of a run, which may begin as a command line does. */
  private static Words words(String text) {
    List<String> all = new ArrayList<>(Shell.words(text));
    if (!all.isEmpty() && all.getFirst().equals(Shell.launcher())) {
      all.removeFirst();
    }
    if (!all.isEmpty() && all.getFirst().equals("run")) {
      all.removeFirst();
    }
    if (all.stream().noneMatch(word -> word.split("=", 2)[0].equals("--seed"))) {
      throw new BadInput("expected a trace, or an app with --seed N and other options of 'run'");
    }
    Words words = new Words();
    new CommandLine(words).parseArgs(all.toArray(String[]::new));
    return words;
  }
}
