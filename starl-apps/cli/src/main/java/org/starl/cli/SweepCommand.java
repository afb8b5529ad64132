package org.starl.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.cli.report.SeedRow;
import org.starl.cli.report.SweepPage;
import org.starl.cli.report.SweepTable;
import org.starl.input.BadInput;
import org.starl.sim.check.Campaign;
import org.starl.sim.kernel.CarrierKind;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl sweep}. */
@Command(
    name = "sweep",
    description =
        "Runs a scenario at many points: each combination of the listed values, or samples of"
            + " ranges; many seeds at each point. Prints a table: the median of each measure, and"
            + " the middle 80 %% of the runs.",
    footer = {
      "",
      "Example: starl sweep scenarios/sweeps/open-road.yaml --csv road.csv --report road.html"
    })
final class SweepCommand extends BaseCommand implements Callable<Integer> {

  private static final List<String> STANDARD =
      List.of("wait_p50_s", "wait_p95_s", "end_s", "datagrams_sent");

  @Parameters(paramLabel = "FILE.yaml", description = "The scenario, and what to vary.")
  private String name = "";

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Option(
      names = "--csv",
      paramLabel = "FILE",
      description = "Write all measures of all points, with units in the header.")
  private @Nullable String csv;

  @Option(
      names = "--report",
      paramLabel = "FILE",
      description = "Write an HTML page: a chart of each measure against each setting.")
  private @Nullable String report;

  @Override
  public Integer call() throws InterruptedException, IOException {
    SweepFile file = SweepFile.read(name);
    List<List<String>> points = file.points();
    List<RunRequest> requests = new ArrayList<>();
    for (List<String> point : points) {
      requests.add(file.request(demos(), point));
    }
    SweepTable table = new SweepTable(file.swept().stream().map(SweptKey::key).toList(), points);
    try (OutputFile csvFile = csv == null ? null : new OutputFile("--csv", csv);
        OutputFile page = report == null ? null : new OutputFile("--report", report)) {
      run(file, requests, table);
      List<String> shown = shown(file, table);
      table.lines(shown).forEach(out()::println);
      if (csvFile != null) {
        csvFile.stream().write(table.csv().getBytes(StandardCharsets.UTF_8));
      }
      if (page != null) {
        String app = file.scenario().app();
        String html = new SweepPage(app, description(file), table, shown).write();
        page.stream().write(html.getBytes(StandardCharsets.UTF_8));
      }
    }
    return table.bad() == 0 ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  /** All runs of all points are one campaign, so that no core waits at the end of a point. */
  private void run(SweepFile file, List<RunRequest> requests, SweepTable table)
      throws InterruptedException {
    CarrierKind carriers = Carriers.select(null, err());
    List<SeedRuns> points =
        requests.stream().map(request -> new SeedRuns(request, carriers, false)).toList();
    List<String> firstBad = new ArrayList<>();
    Seeds.Range seeds = file.seeds();
    long size = seeds.size();
    ProgressLine progress = new ProgressLine(err(), "runs");
    new Campaign(0, points.size() * size - 1, threads.count(), false)
        .run(
            index -> points.get((int) (index / size)).run(seeds.first() + index % size),
            progress::show,
            run -> {
              int point = (int) (run.seed() / size);
              long seed = seeds.first() + run.seed() % size;
              SeedRow row = points.get(point).row(seed, run.outcome());
              table.points().get(point).add(row);
              if (firstBad.isEmpty() && !run.outcome().isGood()) {
                firstBad.add("seed " + seed + ": " + run.outcome().detail());
                firstBad.add("replay: " + requests.get(point).replay(seed));
              }
              return false;
            });
    progress.end();
    firstBad.forEach(err()::println);
  }

  private static List<String> shown(SweepFile file, SweepTable table) {
    if (file.show().isEmpty()) {
      return STANDARD.stream().filter(name -> table.measures().contains(name)).toList();
    }
    for (String measure : file.show()) {
      if (!table.measures().contains(measure)) {
        throw BadInput.at(
            file.scenario().file(),
            file.showLine(),
            "show: %s: expected some of %s"
                .formatted(BadInput.quote(measure), String.join(" ", table.measures())));
      }
    }
    return file.show();
  }

  private Map<String, String> description(SweepFile file) {
    Map<String, String> description = new LinkedHashMap<>();
    List<String> words = List.of("sweep", name);
    description.put("Command", Shell.starl(words));
    description.put(
        "Points",
        file.samples() == 0
            ? file.points().size() + ", all combinations"
            : "%d, a Latin hypercube of seed %d".formatted(file.samples(), file.sampleSeed()));
    description.put("Seeds", file.seeds() + " at each point");
    file.scenario().values().forEach((key, value) -> description.put(key, value));
    return description;
  }
}
