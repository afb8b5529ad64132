package org.starl.cli.campaign;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.Colour;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.cli.run.Outcome;
import org.starl.input.BadInput;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.kernel.CarrierKind;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.time.Time;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl campaign}. */
@Command(
    name = "campaign",
    description =
        "Runs an app with many seeds, on all cores. Prints a table, and the first bad run with its"
            + " replay command. With faults from --chaos and no bad run, repeats runs that reached"
            + " rare states, and draws other random numbers from some time on.",
    footer = {
      "",
      "Example: starl campaign intersection --seeds 1..500 --loss 0.3",
      "         starl campaign mutex --seeds 1..100 --chaos --shrink",
      "         starl campaign race --seeds 1..200 --loss 0.3 --report race.html",
      "         starl campaign mutex --seeds 1..200 --chaos --split fault.restart,fault.restart"
    })
public final class CampaignCommand extends BaseCommand implements Callable<Integer> {

  /** The percentiles of waiting times to show. */
  private static final List<Integer> WAITS = List.of(50, 90, 95, 99, 100);

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Option(
      names = "--seeds",
      paramLabel = "A..B",
      required = true,
      description = "Seeds of the runs, such as 1..200.")
  private String seeds = "";

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Option(names = "--stop", description = "Stop at the first bad run.")
  private boolean stop;

  @Option(
      names = "--until",
      paramLabel = "'95%% < P'",
      defaultValue = "",
      description =
          "Stop as soon as the runs show, with this confidence, that a run is bad with a probability"
              + " below P, or that these seeds cannot show it. The status is then 1.")
  private String until = "";

  @Option(
      names = "--split",
      paramLabel = "EVENTS",
      description =
          "Estimate the probability of rare bad runs: a run goes on as --copies runs after each of"
              + " these events, such as fault.restart,mutex.withdraw. Prints nothing else.")
  private @Nullable String split;

  @Option(
      names = "--copies",
      paramLabel = "N",
      description = "With --split: runs after each event (default: ${DEFAULT-VALUE}).")
  private String copies = "4";

  @Mixin private ShardOptions shards = new ShardOptions();

  @Mixin private EngineOptions engine = new EngineOptions();

  @Option(
      names = "--parquet",
      paramLabel = "FOLDER",
      description = "With --on: also write a row for each run to FOLDER, as Parquet.")
  private @Nullable String parquet;

  @Option(
      names = "--shrink",
      description =
          "Reduce the first bad run to a smaller one that fails in the same way: fewer robots and"
              + " faults, less time.")
  private boolean shrink;

  @Option(
      names = "--report",
      paramLabel = "FILE",
      description = "Write an HTML page: charts, every run, stories and pictures of bad runs.")
  private @Nullable String report;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws InterruptedException, IOException {
    Seeds.Range range = Seeds.Range.of(seeds);
    RunRequest request = options.request(demos());
    SeedWork work = SeedWork.campaign(request, range, Ending.of(stop, until, range));
    if (parquet != null && !engine.isOn()) {
      throw new BadInput("--parquet needs --on ENGINE");
    }
    boolean isShard =
        shards.isOn(
            OptionValues.given("--shrink", shrink, "--report", report, "--on", engine.isOn()));
    // A request that cannot be planned for the first seed is bad input, not a failed run.
    request.plan(range.first()).simulation().build();
    request.unusedRobots(range.first()).ifPresent(err()::println);
    if (split != null) {
      requireAlone();
      return new SplitRuns(request, range, split, copies).run(this, threads.count(), json.isOn());
    }
    if (shards.printJob(this, work)) {
      return ExitStatus.GOOD;
    }
    if (isShard) {
      return shards.run(this, work, threads.count(), json);
    }
    try (ReportFile page = ReportFile.of(report, range)) {
      return run(work, page);
    }
  }

  /** Runs that split have shares, which a table, a part or a search for the first one does not. */
  private void requireAlone() {
    String[] others =
        OptionValues.given(
            "--stop",
            stop,
            "--until",
            until.isEmpty() ? null : until,
            "--out",
            shards.isShared(),
            "--on",
            engine.isOn(),
            "--shrink",
            shrink,
            "--report",
            report);
    if (others.length > 0) {
      throw new BadInput(others[0] + " cannot be used with --split");
    }
  }

  private int run(SeedWork work, @Nullable ReportFile page)
      throws InterruptedException, IOException {
    CarrierKind carriers = Carriers.select(null, err());
    CampaignTally tally = new CampaignTally(SteeredRuns.mayFollow(work.points().getFirst()));
    ProgressLine progress = progress("runs");
    Predicate<SeedRow> collected = collector(work.ending(), tally, page);
    Predicate<SeedRow> isLast =
        row -> {
          if (!row.outcome().isGood()) {
            progress.note("bad so far: " + new FirstBad(work.points().getFirst(), row).line());
          }
          return collected.test(row);
        };
    ShardWork.How how = new ShardWork.How(carriers, threads.count(), progress);
    boolean isWhole =
        engine.isOn()
            ? engine.run(this, work, threads.count(), parquet, isLast, progress)
            : stop().completes(() -> work.runSeeds(work.numbers(), how, page != null, isLast));
    progress.end();
    String interrupted = isWhole ? "" : interrupted(work, tally);
    return print(output(work, carriers, shrink && isWhole, interrupted), tally, page);
  }

  private Output output(SeedWork work, CarrierKind carriers, boolean shrinks, String interrupted) {
    return new Output(
        this, work, carriers, threads.count(), json.isOn(), shrinks, report, typed(), interrupted);
  }

  /** What a signal left undone, and the command that does it. */
  private String interrupted(SeedWork work, CampaignTally tally) {
    Seeds.Range all = work.seeds();
    Seeds.Range rest = new Seeds.Range(all.first() + tally.runs(), all.last());
    return "interrupted after %d of %d runs; to go on: %s"
        .formatted(tally.runs(), all.size(), typedWith("--seeds", rest.toString()));
  }

  /** Adds each row to the sums and the page, and answers whether it decides the campaign. */
  static Predicate<SeedRow> collector(
      Ending ending, CampaignTally tally, @Nullable ReportFile page) {
    Ending.Watch watch = ending.new Watch();
    return row -> {
      tally.add(row);
      if (page != null) {
        page.add(row);
      }
      return watch.decides(tally);
    };
  }

  /**
   * How to print a campaign: the options of a command, and what it ran.
   *
   * @param workers threads for further runs
   * @param report the name of the report's file; null without
   * @param typed the command of the campaign, as the user typed it
   * @param interrupted what a signal left undone; empty if none came
   */
  record Output(
      BaseCommand command,
      SeedWork work,
      CarrierKind carriers,
      int workers,
      boolean isJson,
      boolean shrinks,
      @Nullable String report,
      String typed,
      String interrupted) {

    RunRequest request() {
      return work.points().getFirst();
    }

    Seeds.Range range() {
      return work.seeds();
    }

    Ending ending() {
      return work.ending();
    }
  }

  /** Makes the steered runs of a campaign, prints it and writes its page; returns the exit status. */
  static int print(Output output, CampaignTally tally, @Nullable ReportFile page)
      throws InterruptedException, IOException {
    PrintWriter out = output.command().out();
    PrintWriter err = output.command().err();
    if (tally.runs() == 0) {
      err.println(output.interrupted());
      return ExitStatus.VIOLATED;
    }
    RunRequest request = output.request();
    Seeds.Range range = output.range();
    SteeredRuns steered = steered(output, tally, err);
    SeedRow ofSeeds = tally.firstBad();
    FirstBad bad = ofSeeds == null ? steered.firstBad() : new FirstBad(request, ofSeeds);
    if (!output.isJson()) {
      table(request, tally).forEach(out::println);
      SpecReport spec = monitors(request, range.first()).report();
      spec.exceptions().forEach(out::println);
      Outcome.inapplicable(spec).forEach(out::println);
      tally.chances().lines().forEach(out::println);
      output.ending().lines(tally).forEach(out::println);
      steered.lines().forEach(out::println);
      tally.coverage().lines().forEach(out::println);
    }
    if (!tally.neverChecked().isEmpty()) {
      err.println(
          "never checked in %d runs: %s%s"
              .formatted(
                  tally.runs(),
                  String.join(" ", tally.neverChecked()),
                  tally.leavesUnchecked() ? ": expected a check in some run" : ""));
    }
    if (bad != null) {
      err.println(Colour.bad(bad.line()));
      sentences(bad, tally.violated()).forEach(err::println);
      err.println(bad.replay());
    }
    // What takes long follows the verdict.
    Shrinking.Shrunk shrunk =
        bad == null || !output.shrinks()
            ? null
            : new Shrinking(
                    output.command().demos(), bad.request(), bad.row().seed(), output.carriers())
                .run(output.command());
    if (shrunk != null) {
      shrunk.lines().forEach(err::println);
    }
    if (page != null) {
      page.write(
          ReportFile.description(request, output.typed(), range),
          seed -> SeedRuns.plan(request, seed, output.carriers()),
          shrunk == null ? List.of() : shrunk.lines(),
          steered,
          tally,
          output.command());
    }
    if (output.isJson()) {
      Map<String, Object> summary = summary(request, range, tally);
      summary.put("error_rates", tally.chances().json());
      if (output.ending().until() != null) {
        summary.put("until", output.ending().untilText());
        summary.put("until_shown", !output.ending().isMissed(tally));
      }
      summary.put("interrupted", !output.interrupted().isEmpty());
      summary.put("never_checked", List.copyOf(tally.neverChecked()));
      summary.putAll(steered.json());
      if (shrunk != null) {
        summary.put("shrunk", shrunk.json());
      }
      if (output.report() != null) {
        summary.put("report", output.report());
      }
      out.println(Json.line(summary));
    } else if (output.report() != null) {
      out.println("report: " + output.report());
    }
    if (!output.interrupted().isEmpty()) {
      err.println(output.interrupted());
    }
    return bad != null || tally.leavesUnchecked() || output.ending().isMissed(tally)
        ? ExitStatus.VIOLATED
        : ExitStatus.GOOD;
  }

  /**
   * The first bad run of a campaign.
   *
   * @param request of this run
   */
  record FirstBad(RunRequest request, SeedRow row) {

    String line() {
      return "seed " + row.seed() + ": " + row.outcome().detail();
    }

    String replay() {
      return "replay: " + request.replay(row.seed());
    }
  }

  private static SteeredRuns steered(Output output, CampaignTally tally, PrintWriter err)
      throws InterruptedException {
    SteeredRuns steered =
        new SteeredRuns(
            output.request(), output.work().keys().getFirst(), tally, output.carriers());
    if (!output.interrupted().isEmpty()) {
      return steered;
    }
    ProgressLine progress = new ProgressLine(err, "steered runs");
    output
        .command()
        .stop()
        .completes(() -> steered.run(tally, output.carriers(), output.workers(), progress));
    progress.end();
    return steered;
  }

  /**
   * What each lemma says that a run violated first.
   *
   * @param violated the lemmas that runs of the campaign's seeds violated first; will be changed
   */
  private static List<String> sentences(FirstBad bad, SortedSet<String> violated) {
    if (bad.row().outcome().verdict() == Verdict.VIOLATED) {
      violated.add(bad.row().outcome().what());
    }
    List<String> lines = new ArrayList<>();
    if (!violated.isEmpty()) {
      for (Monitor monitor : monitors(bad.request(), bad.row().seed()).monitors()) {
        for (String lemma : monitor.lemmas()) {
          if (!monitor.description(lemma).isEmpty() && violated.remove(lemma)) {
            lines.add("  " + lemma + ": " + monitor.description(lemma));
          }
        }
      }
    }
    return lines;
  }

  private static Monitors monitors(RunRequest request, long seed) {
    return Monitors.of(request.plan(seed).simulation().build().plan().monitors());
  }

  private static List<String> table(RunRequest request, CampaignTally tally) {
    Map<String, String> rows = new LinkedHashMap<>();
    rows.put(request.demo().name(), "");
    rows.put("runs", Long.toString(tally.runs()));
    for (Verdict verdict : Verdict.values()) {
      rows.put("  " + verdict.name().toLowerCase(Locale.ROOT), "" + tally.count(verdict));
    }
    rows.put(tally.tasks() + " finished", Long.toString(tally.completed()));
    tally.counts().forEach((name, count) -> rows.put(name, Long.toString(count)));
    tally
        .waitsNs(WAITS)
        .forEach((percent, waitNs) -> rows.put("wait, " + name(percent), Time.text(waitNs, 1)));
    for (String figure : tally.figures()) {
      for (int percent : new int[] {50, 100}) {
        rows.put(figure + " per run, " + name(percent), figure(tally.percentile(figure, percent)));
      }
    }
    int nameWidth = width(rows.keySet());
    int valueWidth = width(rows.values());
    List<String> lines = new ArrayList<>();
    rows.forEach((name, value) -> {
      String gap = " ".repeat(nameWidth - name.length() + 2 + valueWidth - value.length());
      lines.add((name + gap + value).stripTrailing());
    });
    return lines;
  }

  private static int width(Collection<String> cells) {
    return cells.stream().mapToInt(String::length).max().orElse(0);
  }

  /** A whole number, or a number with one decimal. */
  private static String figure(double value) {
    return value == Math.rint(value)
        ? Long.toString((long) value)
        : String.format(Locale.ROOT, "%.1f", value);
  }

  private static Map<String, Object> summary(
      RunRequest request, Seeds.Range range, CampaignTally tally) {
    Map<String, Object> summary = new LinkedHashMap<>();
    summary.put("app", request.demo().name());
    summary.put("seeds", range.first() + ".." + range.last());
    for (Verdict verdict : Verdict.values()) {
      summary.put(verdict.name().toLowerCase(Locale.ROOT), tally.count(verdict));
    }
    summary.put("completed", tally.completed());
    tally.counts().forEach((name, count) -> summary.put(name.replaceAll("[: ]+", "_"), count));
    tally
        .waitsNs(WAITS)
        .forEach((percent, ns) -> summary.put("wait_p" + percent + "_s", Time.seconds(ns)));
    for (String figure : tally.figures()) {
      summary.put(figure + "_p50", tally.percentile(figure, 50));
    }
    SeedRow bad = tally.firstBad();
    if (bad != null) {
      summary.put("first_bad_seed", bad.seed());
      summary.put("first_bad", bad.outcome().detail());
    }
    return summary;
  }

  private static String name(int percent) {
    return switch (percent) {
      case 50 -> "median";
      case 100 -> "maximum";
      default -> percent + "th percentile";
    };
  }
}
