package org.starl.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;
import org.starl.apps.Plan;
import org.starl.cli.report.Coverage;
import org.starl.cli.report.MessageCounts;
import org.starl.cli.report.Totals;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.kernel.CarrierKind;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.time.Time;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl campaign}. */
@Command(
    name = "campaign",
    description =
        "Runs an app with many seeds, on all cores. Prints a table, and the first bad run with its"
            + " replay command.",
    footer = {
      "",
      "Example: starl campaign intersection --seeds 1..500 --loss 0.3",
      "         starl campaign mutex --seeds 1..100 --chaos --shrink",
      "         starl campaign race --seeds 1..200 --loss 0.3 --report race.html"
    })
final class CampaignCommand extends BaseCommand implements Callable<Integer> {

  private static final int MAX_THREADS = 1024;

  /** The percentiles of waiting times to show. */
  private static final int[] WAITS = {50, 90, 95, 99, 100};

  @Mixin private RunOptions options = new RunOptions();

  @Option(
      names = "--seeds",
      paramLabel = "A..B",
      required = true,
      description = "Seeds of the runs, such as 1..200.")
  private String seeds = "";

  @Option(
      names = "--threads",
      paramLabel = "N",
      description = "Number of threads (default: one per core).")
  private @Nullable String threads;

  @Option(names = "--stop", description = "Stop at the first bad run.")
  private boolean stop;

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
    Campaign campaign = new Campaign(range.first(), range.last(), workers(), stop);
    // A request that cannot be planned for the first seed is bad input, not a failed run.
    request.plan(range.first()).simulation().build();
    request.unusedRobots(range.first()).ifPresent(err()::println);
    try (ReportFile page = ReportFile.of(report, range)) {
      return run(campaign, request, range, page);
    }
  }

  private int run(
      Campaign campaign, RunRequest request, Seeds.Range range, @Nullable ReportFile page)
      throws InterruptedException, IOException {
    PrintWriter out = out();
    PrintWriter err = err();
    CarrierKind carriers = Carriers.select(null, err);
    NavigableMap<Long, Measures> measured = new ConcurrentSkipListMap<>();
    Chances chances = new Chances(new ConcurrentSkipListMap<>());
    Coverage coverage = new Coverage();
    ProgressLine progress = new ProgressLine(err, "runs");
    CampaignResult result =
        campaign.run(
            seed -> run(request, seed, carriers, measured, chances, coverage, page),
            progress::show);
    progress.end();
    // With --stop, runs after the first bad one do not count.
    Totals totals = new Totals(measured.headMap(result.runs().getLast().seed(), true).values());
    CampaignResult.Run bad = result.firstBad();
    Shrinking.Shrunk shrunk =
        bad == null || !shrink
            ? null
            : new Shrinking(demos(), request, bad.seed(), carriers).run(err);
    if (page != null) {
      page.write(
          ReportFile.description(request, typed(), range),
          result,
          seed -> plan(request, seed, carriers),
          shrunk == null ? List.of() : shrunk.lines(),
          err);
    }
    if (json.isOn()) {
      Map<String, Object> summary = summary(request, range, result, totals);
      summary.put("error_rates", chances.json(result));
      summary.put("never_checked", List.copyOf(result.neverChecked()));
      if (shrunk != null) {
        summary.put("shrunk", shrunk.json());
      }
      if (report != null) {
        summary.put("report", report);
      }
      out.println(Json.line(summary));
    } else {
      table(request, result, totals).forEach(out::println);
      SpecReport spec = monitors(request, range.first()).report();
      spec.exceptions().forEach(out::println);
      Outcome.inapplicable(spec).forEach(out::println);
      chances.lines(result).forEach(out::println);
      // With --stop, the threads' timing decides which runs after the first bad one took place.
      if (!stop) {
        coverage.lines().forEach(out::println);
      }
      if (report != null) {
        out.println("report: " + report);
      }
    }
    if (!result.neverChecked().isEmpty()) {
      err.println(
          "never checked in %d runs: %s%s"
              .formatted(
                  result.runs().size(),
                  String.join(" ", result.neverChecked()),
                  result.leavesUnchecked() ? ": expected a check in some run" : ""));
    }
    if (bad == null) {
      return result.leavesUnchecked() ? ExitStatus.VIOLATED : ExitStatus.GOOD;
    }
    err.println("seed " + bad.seed() + ": " + bad.outcome().detail());
    sentences(request, result).forEach(err::println);
    err.println("replay: " + request.replay(bad.seed()));
    if (shrunk != null) {
      shrunk.lines().forEach(err::println);
    }
    return ExitStatus.VIOLATED;
  }

  /** What each lemma says that a run violated first. */
  private static List<String> sentences(RunRequest request, CampaignResult result) {
    SortedSet<String> violated = new TreeSet<>();
    result
        .runs()
        .forEach(run -> {
          if (run.outcome().verdict() == Verdict.VIOLATED) {
            violated.add(run.outcome().what());
          }
        });
    List<String> lines = new ArrayList<>();
    CampaignResult.Run bad = result.firstBad();
    if (bad != null && !violated.isEmpty()) {
      for (Monitor monitor : monitors(request, bad.seed()).monitors()) {
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

  /** The command line as the user typed it. */
  private String typed() {
    CommandLine root = spec().root().commandLine();
    return Shell.starl(root.getParseResult().originalArgs());
  }

  private int workers() {
    return threads == null
        ? Runtime.getRuntime().availableProcessors()
        : OptionValues.whole("--threads", threads, 1, MAX_THREADS);
  }

  private static Plan plan(RunRequest request, long seed, CarrierKind carriers) {
    Plan plan = correct(seed, () -> request.plan(seed));
    plan.simulation().carriers(carriers);
    return plan;
  }

  /** Bad input in the plan of this seed is a failed run: the plan of the first seed was correct. */
  private static <T> T correct(long seed, Supplier<T> work) {
    try {
      return work.get();
    } catch (BadInput e) {
      throw new IllegalStateException("seed " + seed + ": " + e.getMessage(), e);
    }
  }

  private static RunOutcome run(
      RunRequest request,
      long seed,
      CarrierKind carriers,
      Map<Long, Measures> measured,
      Chances chances,
      Coverage coverage,
      @Nullable ReportFile page) {
    Plan plan = plan(request, seed, carriers);
    chances.watch(seed, plan.simulation());
    MessageCounts messages = page == null ? null : ReportFile.watch(plan);
    SimResult result = correct(seed, () -> plan.simulation().build().run());
    if (page != null && messages != null) {
      page.put(seed, result, plan, messages);
    }
    coverage.add(result.spec());
    Measures measures = plan.story().measures();
    measured.put(seed, measures);
    RunOutcome outcome = RunOutcome.of(result);
    SortedMap<String, Double> figures = new TreeMap<>(outcome.figures());
    figures.putAll(measures.figures());
    return outcome.withFigures(figures);
  }

  private static List<String> table(RunRequest request, CampaignResult result, Totals totals) {
    Map<String, String> rows = new LinkedHashMap<>();
    rows.put(request.demo().name(), "");
    rows.put("runs", Long.toString(result.runs().size()));
    for (Verdict verdict : Verdict.values()) {
      rows.put("  " + verdict.name().toLowerCase(Locale.ROOT), "" + result.count(verdict));
    }
    rows.put("robots finished", Long.toString(totals.completed()));
    totals.counts().forEach((name, count) -> rows.put(name, Long.toString(count)));
    for (int percent : WAITS) {
      rows.put("wait, " + name(percent), Time.text(totals.waitNs(percent), 1));
    }
    for (String figure : result.figures()) {
      for (int percent : new int[] {50, 100}) {
        rows.put(figure + " per run, " + name(percent), figure(result.percentile(figure, percent)));
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
      RunRequest request, Seeds.Range range, CampaignResult result, Totals totals) {
    Map<String, Object> summary = new LinkedHashMap<>();
    summary.put("app", request.demo().name());
    summary.put("seeds", range.first() + ".." + range.last());
    for (Verdict verdict : Verdict.values()) {
      summary.put(verdict.name().toLowerCase(Locale.ROOT), result.count(verdict));
    }
    summary.put("completed", totals.completed());
    totals.counts().forEach((name, count) -> summary.put(name.replaceAll("[: ]+", "_"), count));
    for (int percent : WAITS) {
      summary.put("wait_p" + percent + "_s", Time.seconds(totals.waitNs(percent)));
    }
    for (String figure : result.figures()) {
      summary.put(figure + "_p50", result.percentile(figure, 50));
    }
    CampaignResult.Run bad = result.firstBad();
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
