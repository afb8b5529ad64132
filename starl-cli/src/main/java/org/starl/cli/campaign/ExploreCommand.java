package org.starl.cli.campaign;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.Colour;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.cli.request.TraceFile;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.Setting;
import org.starl.sim.explore.Bounds;
import org.starl.sim.explore.Exploration;
import org.starl.sim.explore.ExplorationTally;
import org.starl.sim.explore.Explorer;
import org.starl.sim.explore.Strategy;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.TimeRange;
import org.starl.sim.kernel.CarrierKind;
import org.starl.time.Time;
import org.starl.trace.TraceHeader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl explore}. */
@Command(
    name = "explore",
    description =
        "Repeats one run with other orders of its events, on all cores: datagrams arrive earlier or"
            + " later within bounds, some are lost, robots crash. Prints the first order that goes"
            + " wrong, with its replay command.",
    footer = {
      "",
      "Example: starl explore mutex --robots 3 --seed 1",
      "         starl explore intersection --seed 1 --strategy pct --depth 5 --losses 2",
      "         starl explore registration --robots 2 --seed 1 --strategy exhaustive --depth 6",
      "         starl explore mutex --strategy states --robots 3 --crashes 1",
      "         starl explore mutex --seed 1 --schedules 1000000 --shard 17/64 --out part-17",
      "         starl explore intersection --from out/crossing.trace@12.3s --strategy exhaustive"
    })
public final class ExploreCommand extends BaseCommand implements Callable<Integer> {

  private static final int MOST = 10_000_000;
  private static final int MOST_FAULTS = 1000;
  private static final int USUAL_CHANGES = 3;
  private static final int USUAL_CHOICES = 6;
  private static final int USUAL_STATES = 5_000_000;

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Mixin private SeedOption seedOption = new SeedOption();

  @Option(
      names = "--strategy",
      paramLabel = "NAME",
      description =
          "random: delays, losses and crashes are drawn. pct: links get priorities, a few of which"
              + " change. exhaustive: every order in which the next datagrams can arrive, the"
              + " smallest changes first. states: no run, but all states of a protocol's code"
              + " (mutex, agreement, barrier, election, registration) without a clock, within"
              + " bounds (--robots, --crashes, --set)."
              + " Default: ${DEFAULT-VALUE}.")
  private String strategyName = "pct";

  @Option(
      names = "--schedules",
      paramLabel = "N",
      description = "The largest number of runs (default: ${DEFAULT-VALUE}).")
  private String schedules = "1000";

  @Option(
      names = "--states",
      paramLabel = "N",
      description = "For states, the largest number of states (default: 5000000).")
  private @Nullable String states;

  @Option(
      names = "--depth",
      paramLabel = "D",
      description =
          "For pct, the changes of priorities (default: 3). For exhaustive, the number of datagrams"
              + " whose arrival is chosen (default: 6).")
  private @Nullable String depth;

  @Option(
      names = "--delays",
      paramLabel = "A..B",
      description =
          "The shortest and the longest delay of a datagram (default: ${DEFAULT-VALUE}). An order"
              + " that no such delays give is not tried.")
  private String delays = "1ms..800ms";

  @Option(
      names = "--losses",
      paramLabel = "N",
      description = "The largest number of lost datagrams, besides --loss (default: 0).")
  private String losses = "0";

  @Option(
      names = "--crashes",
      paramLabel = "N",
      description = "The largest number of crashes (default: 0).")
  private String crashes = "0";

  @Option(
      names = "--down",
      paramLabel = "TIME",
      description = "Time from a crash to the restart (default: ${DEFAULT-VALUE}).")
  private String down = "2s";

  @Option(
      names = "--from",
      paramLabel = "TIME|TRACE@TIME",
      description =
          "Change nothing before this time of the run, or of the run of a trace (default: its"
              + " start).")
  private String from = "0s";

  @Option(
      names = "--chart",
      paramLabel = "FILE",
      description =
          "Write a message sequence chart of the events before the failure, an SVG picture.")
  private @Nullable String chart;

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Mixin private ShardOptions shards = new ShardOptions();

  @Mixin private EngineOptions engine = new EngineOptions();

  @Mixin private JsonOption json = new JsonOption();

  /** The run to repeat. */
  private record Subject(RunRequest request, long seed, long fromNs) {}

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (strategyName.strip().equals(StateExploration.STRATEGY)) {
      int mostStates =
          states == null
              ? USUAL_STATES
              : OptionValues.whole("--states", states, 1, StateExploration.MOST_STATES);
      return new StateExploration(
              options.name(),
              spec().commandLine().getParseResult().matchedOptions(),
              options.sets())
          .run(mostStates, json.isOn(), this);
    }
    if (states != null) {
      throw new BadInput("--states: expected --strategy " + StateExploration.STRATEGY);
    }
    Strategy strategy = OptionValues.read("--strategy", strategyName, Strategy::parse);
    int most = OptionValues.whole("--schedules", schedules, 1, MOST);
    int usual = strategy == Strategy.EXHAUSTIVE ? USUAL_CHOICES : USUAL_CHANGES;
    int changes = depth == null ? usual : OptionValues.whole("--depth", depth, 1, MOST_FAULTS);
    boolean isShard = shards.isOn(OptionValues.given("--chart", chart, "--on", engine.isOn()));
    if (shards.isShared() && !from.contains("@")) {
      seedOption.requireGiven();
    }
    Subject subject = subject();
    Exploration exploration =
        new Exploration(strategy, changes, subject.seed(), most, bounds(subject));
    ExploreWork work = new ExploreWork(subject.request(), subject.seed(), exploration);
    if (shards.printJob(this, work)) {
      return ExitStatus.GOOD;
    }
    if (isShard) {
      return shards.run(this, work, threads.count(), json);
    }
    try (OutputFile file = chart == null ? null : new OutputFile("--chart", chart)) {
      return explore(work, file);
    }
  }

  private int explore(ExploreWork work, @Nullable OutputFile file)
      throws InterruptedException, IOException {
    Output output = new Output(this, work, Carriers.select(null, err()), json.isOn(), chart, file);
    ExplorationTally tally = new ExplorationTally(work.exploration());
    ProgressLine progress = progress("schedules");
    boolean[] isAll = new boolean[1];
    boolean isWhole =
        engine.isOn()
            ? engine.run(
                this, work, threads.count(), null, row -> tally.add(row.explored()), progress)
            : stop()
                .completes(() ->
                    isAll[0] =
                        work.explorer(
                                new ShardWork.How(
                                    output.carriers(),
                                    threads.count(),
                                    (finished, planned, bad) -> progress.show(finished, planned)))
                            .run(any -> true, List.of(), tally::add));
    progress.end();
    Explorer.Result result = tally.result(isAll[0]);
    if (!engine.isOn() && !json.isOn()) {
      err()
          .println(
              "%,.0f steps a second"
                  .formatted(result.steps() / Time.seconds(progress.elapsedNs())));
    }
    int status = print(output, result);
    if (!isWhole) {
      err()
          .println(
              shards.interrupted(
                  this, result.schedules(), work.exploration().mostSchedules(), "schedules"));
    }
    return status;
  }

  private Subject subject() {
    int at = from.lastIndexOf('@');
    String time = from.substring(at + 1);
    long fromNs = OptionValues.read("--from", time, Quantities::durationNs);
    if (at < 0) {
      return new Subject(options.request(demos()), seedOption.value(), fromNs);
    }
    TraceFile trace = TraceFile.open(from.substring(0, at), demos());
    options.requireNoneFor(trace.name());
    seedOption.requireNoneFor(trace.name());
    TraceHeader header = trace.header();
    if (!header.scenario().equals(options.name())) {
      throw new BadInput(
          "--from: %s: a trace of %s, not of %s"
              .formatted(trace.name(), header.scenario(), options.name()));
    }
    trace.requireRepeatable();
    if (header.behaviourSeed() != TraceHeader.behaviourSeedOf(header.scenarioSeed())) {
      throw new BadInput(
          trace.name() + ": its behaviour has a seed of its own; expected a trace of 'starl run'");
    }
    return new Subject(trace.request(), header.scenarioSeed(), fromNs);
  }

  private Bounds bounds(Subject subject) {
    TimeRange delay = OptionValues.read("--delays", delays, TimeRange::parse);
    int lost = OptionValues.whole("--losses", losses, 0, MOST_FAULTS);
    int crashed = OptionValues.whole("--crashes", crashes, 0, MOST_FAULTS);
    long downNs = OptionValues.read("--down", down, Quantities::durationNs);
    if (downNs == 0) {
      throw new BadInput("--down: " + BadInput.quote(down) + ": expected a time above 0");
    }
    RunRequest request = subject.request();
    Plan plan = request.plan(subject.seed());
    // A request that cannot be built is bad input, not a failed run.
    plan.simulation().build();
    Envelope envelope = request.demo().envelope();
    requireTolerated("--losses", lost, envelope != Envelope.NONE, request);
    requireTolerated("--crashes", crashed, envelope.hasCrashes(), request);
    long drawnNs = plan.simulation().settings().get(Setting.MESSAGE_DELAY).longestNs();
    return new Bounds(
        subject.fromNs(),
        delay.leastNs(),
        delay.mostNs(),
        Math.max(0, delay.mostNs() - drawnNs),
        lost,
        crashed,
        downNs);
  }

  /** What an app does not promise to tolerate is no finding. */
  private static void requireTolerated(
      String option, int count, boolean isTolerated, RunRequest request) {
    if (count > 0 && !isTolerated) {
      Envelope envelope = request.demo().envelope();
      throw new BadInput(
          "%s: %s does not promise to tolerate them: its faults are '%s' (%s)"
              .formatted(option, request.demo().name(), envelope, envelope.meaning()));
    }
  }

  /**
   * How to print an exploration: the options of a command, and what it explored.
   *
   * @param chart the name of {@code file}; both null without
   */
  record Output(
      BaseCommand command,
      ExploreWork work,
      CarrierKind carriers,
      boolean isJson,
      @Nullable String chart,
      @Nullable OutputFile file) {}

  /** Shrinks the bad schedule and prints the result; returns the exit status. */
  static int print(Output output, Explorer.Result result) throws InterruptedException, IOException {
    ExploreWork work = output.work();
    PrintWriter out = output.command().out();
    PrintWriter err = output.command().err();
    Explorer.Found found = result.found();
    if (!output.isJson()) {
      out.println(
          "%s, seed %d: %,d schedules (%s, depth %d%s), %,d orders, %,d steps; %s"
              .formatted(
                  work.app(),
                  work.seed(),
                  result.schedules(),
                  work.exploration().strategy(),
                  work.exploration().depth(),
                  result.isComplete() ? ", all that there are" : "",
                  result.orders(),
                  result.steps(),
                  found == null ? "none went wrong" : "number " + found.number() + " went wrong"));
    }
    if (found != null) {
      err.println(Colour.bad("schedule " + found.number() + ": " + found.outcome().detail()));
    }
    // Shrinking takes long; it follows the verdict.
    Shrinking.Shrunk shrunk =
        found == null
            ? null
            : new Shrinking(
                    output.command().demos(),
                    work.request().withFaults(found.schedule()),
                    work.seed(),
                    output.carriers())
                .run(output.command());
    if (output.isJson()) {
      out.println(Json.line(summary(work, result, shrunk)));
    }
    if (shrunk == null) {
      return ExitStatus.GOOD;
    }
    shrunk.lines().forEach(err::println);
    if (output.file() != null) {
      output.file().stream().write(shrunk.chart().getBytes(StandardCharsets.UTF_8));
      err.println("chart: " + output.chart());
    }
    return ExitStatus.VIOLATED;
  }

  private static Map<String, Object> summary(
      ExploreWork work, Explorer.Result result, Shrinking.@Nullable Shrunk shrunk) {
    Map<String, Object> summary = new LinkedHashMap<>();
    summary.put("app", work.app());
    summary.put("seed", work.seed());
    summary.put("strategy", work.exploration().strategy().toString());
    summary.put("depth", work.exploration().depth());
    summary.put("schedules", result.schedules());
    summary.put("orders", result.orders());
    summary.put("steps", result.steps());
    summary.put("complete", result.isComplete());
    Explorer.Found found = result.found();
    if (found != null && shrunk != null) {
      summary.put("bad_schedule", found.number());
      summary.put("bad", found.outcome().detail());
      List<String> faults = new ArrayList<>();
      found.schedule().forEach(fault -> faults.add(fault.toString()));
      summary.put("faults", faults);
      summary.put("shrunk", shrunk.json());
    }
    return summary;
  }
}
