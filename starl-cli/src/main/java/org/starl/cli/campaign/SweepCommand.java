package org.starl.cli.campaign;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.Colour;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.Shell;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.report.SeedRow;
import org.starl.cli.report.SweepPage;
import org.starl.cli.report.SweepTable;
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
      "Example: starl sweep scenarios/sweeps/open-road.yaml --csv road.csv --report road.html",
      "         starl sweep scenarios/sweeps/open-road.yaml --shard 1/4 --out part-1"
    })
public final class SweepCommand extends BaseCommand implements Callable<Integer> {

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

  @Mixin private ShardOptions shards = new ShardOptions();

  @Mixin private EngineOptions engine = new EngineOptions();

  @Override
  public Integer call() throws InterruptedException, IOException {
    boolean isShard =
        shards.isOn(OptionValues.given("--csv", csv, "--report", report, "--on", engine.isOn()));
    SweepFile file = SweepFile.read(name);
    SeedWork work = SeedWork.sweep(file, demos());
    if (shards.printJob(this, work)) {
      return ExitStatus.GOOD;
    }
    if (isShard) {
      return shards.run(this, work, threads.count(), new JsonOption());
    }
    try (Output output = new Output(this, file, work, csv, report)) {
      ProgressLine progress = progress("runs");
      Predicate<SeedRow> rows = work.checked(output::add);
      // All runs of all points are one campaign, so that no core waits at the end of a point.
      boolean isWhole =
          engine.isOn()
              ? engine.run(this, work, threads.count(), null, rows, progress)
              : stop()
                  .completes(() ->
                      work.runSeeds(
                          work.numbers(),
                          new ShardWork.How(
                              Carriers.select(null, err()), threads.count(), progress),
                          false,
                          rows));
      progress.end();
      int status = output.print(isWhole);
      if (!isWhole) {
        err().println(shards.interrupted(this, output.table.runs(), work.numbers().size(), "runs"));
      }
      return status;
    }
  }

  /** Collects the rows of a sweep, and prints its result. */
  static final class Output implements Closeable {
    private final BaseCommand command;
    private final SweepFile file;
    private final SeedWork work;
    private final SweepTable table;
    private final @Nullable OutputFile csv;
    private final @Nullable OutputFile page;
    private @Nullable SeedRow firstBad;

    /**
     * @param csv the name of a file, as {@code report}; null without
     */
    Output(
        BaseCommand command,
        SweepFile file,
        SeedWork work,
        @Nullable String csv,
        @Nullable String report) {
      this.command = command;
      this.file = file;
      this.work = work;
      table = new SweepTable(file.swept().stream().map(SweptKey::key).toList(), file.points());
      this.csv = csv == null ? null : new OutputFile("--csv", csv);
      page = report == null ? null : new OutputFile("--report", report);
    }

    /** Adds the next row; none is the last. */
    boolean add(SeedRow row) {
      table.add(row);
      if (firstBad == null && !row.outcome().isGood()) {
        firstBad = row;
      }
      return false;
    }

    private String replay(SeedRow row) {
      return work.points().get(row.point()).replay(row.seed());
    }

    /**
     * Prints the table and writes the files; returns the exit status.
     *
     * @param isWhole whether all runs have ended
     */
    int print(boolean isWhole) throws IOException {
      if (table.runs() == 0) {
        return ExitStatus.VIOLATED;
      }
      if (isWhole) {
        file.requireShown(table.measures());
      }
      List<String> shown =
          (file.show().isEmpty() ? STANDARD : file.show())
              .stream().filter(name -> table.measures().contains(name)).toList();
      table.lines(shown).forEach(command.out()::println);
      if (firstBad != null) {
        PrintWriter err = command.err();
        err.println(Colour.bad("seed " + firstBad.seed() + ": " + firstBad.outcome().detail()));
        err.println("replay: " + replay(firstBad));
      }
      if (csv != null) {
        csv.stream().write(table.csv().getBytes(StandardCharsets.UTF_8));
      }
      if (page != null) {
        String html =
            new SweepPage(work.app(), description(file), table, shown, this::replay).write();
        page.stream().write(html.getBytes(StandardCharsets.UTF_8));
      }
      return table.bad() == 0 ? ExitStatus.GOOD : ExitStatus.VIOLATED;
    }

    @Override
    public void close() throws IOException {
      try {
        if (csv != null) {
          csv.close();
        }
      } finally {
        if (page != null) {
          page.close();
        }
      }
    }
  }

  private static Map<String, String> description(SweepFile file) {
    Map<String, String> description = new LinkedHashMap<>();
    description.put("Command", Shell.starl(List.of("sweep", file.scenario().file())));
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
