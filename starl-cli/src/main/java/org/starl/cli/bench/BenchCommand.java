package org.starl.cli.bench;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.bench.CheckSpeed;
import org.starl.bench.CrossingRules;
import org.starl.bench.FleetRates;
import org.starl.bench.Measurement;
import org.starl.bench.MutexCost;
import org.starl.bench.PatrolWorkload;
import org.starl.bench.Workload;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.JsonOption;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.view.ViewBench;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl bench}. */
@Command(
    name = "bench",
    description =
        "Measures a workload: runs it several times in this JVM, the first time cold, and prints"
            + " its speed.",
    footer = {"", "Example: starl bench b1 --robots 10000 --style blocking"})
public final class BenchCommand extends BaseCommand implements Callable<Integer> {

  public static final String VIEW = "view";
  public static final String VIEW_SUMMARY =
      "pictures per second of the viewer, with 100, 1000 and 10000 robots of b2";

  /** Real seconds for each number of robots. */
  private static final double VIEW_S = 8;

  /** How long cars arrive in b4a. */
  private static final Duration ARRIVALS = Duration.ofMinutes(10);

  @Parameters(
      index = "0",
      paramLabel = "WORKLOAD",
      description =
          "b1, b2, b3a, b3b, b3c, b3 for all three, b4a, b4b, b5, fleet, mutex, view or apps; see"
              + " 'starl list'.")
  private String name = "";

  @Option(
      names = "--robots",
      paramLabel = "N",
      description =
          "Number of robots (default: 256; view: 100, 1000 and 10000). With mutex and fleet: the"
              + " largest number (default: 64 and 8).")
  private @Nullable String robots;

  @Option(
      names = "--style",
      paramLabel = "STYLE",
      description = "blocking, step or, with b1, suspended (default: blocking; b3: step).")
  private Workload.@Nullable Style style;

  @Option(
      names = "--runs",
      paramLabel = "N",
      description = "Number of runs (default: 5; b4a: 2 a row; b5: 100; fleet: 1 a row).")
  private @Nullable String runs;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Seed of the runs (default: ${DEFAULT-VALUE}).")
  private String seed = "1";

  @Option(
      names = "--inputs",
      paramLabel = "FOLDER",
      description = "With apps: the folder with the apps' input files.")
  private @Nullable Path inputs;

  @Option(
      names = "--seeds",
      paramLabel = "A..B",
      defaultValue = "1..200",
      description = "With apps: seeds of the runs (default: ${DEFAULT-VALUE}).")
  private String seeds = "1..200";

  @Option(names = "--app", paramLabel = "APP", description = "With apps: only this app.")
  private @Nullable String app;

  @Option(
      names = "--input",
      paramLabel = "NAME",
      description = "With apps: only inputs of this name, such as four.wpt.")
  private @Nullable String input;

  @Mixin private JsonOption json = new JsonOption();

  @Override
  public Integer call() throws InterruptedException {
    switch (name) {
      case MutexCost.NAME -> showMutexCost();
      case CrossingRules.NAME -> showCrossingRules();
      case CheckSpeed.NAME -> showCheckSpeed();
      case FleetRates.NAME -> showFleetRates();
      case VIEW -> showView();
      case AppsTable.NAME -> {
        return showApps() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
      }
      default -> showSpeed();
    }
    return ExitStatus.GOOD;
  }

  private void showSpeed() {
    // b3 stands for b3a, b3b and b3c.
    List<Workload> workloads =
        Workload.all().stream()
            .filter(
                one -> one.name().equals(name) || (one.name().matches("b3.") && name.equals("b3")))
            .toList();
    if (workloads.isEmpty()) {
      throw new BadInput(
          "no workload is called %s: expected %s, b4a, b5, fleet, mutex, view or apps"
              .formatted(
                  BadInput.quote(name),
                  Workload.all().stream().map(Workload::name).collect(Collectors.joining(", "))));
    }
    Carriers.select(null, err());
    workloads.forEach(this::showSpeed);
  }

  private void showSpeed(Workload workload) {
    int planned = runs(5);
    int count = robots(256, 1, 10_000_000);
    ProgressLine progress = progress("runs");
    List<Measurement> taken =
        Measurement.take(
            workload,
            count,
            style == null ? workload.style() : style,
            planned,
            Seeds.of(seed),
            done -> progress.show(done, planned));
    progress.end();
    taken.forEach(run -> json.print(out(), run.asMap(), List.of(line(run))));
    out().flush();
  }

  private int runs(int otherwise) {
    return runs == null ? otherwise : OptionValues.whole("--runs", runs, 1, 100_000);
  }

  private int robots(int otherwise, int min, int max) {
    return robots == null ? otherwise : OptionValues.whole("--robots", robots, min, max);
  }

  private boolean showApps() throws InterruptedException {
    if (inputs == null) {
      throw new BadInput("bench apps: expected --inputs FOLDER, the apps' input files");
    }
    CarrierKind carriers = Carriers.select(null, err());
    return new AppsTable(inputs, Seeds.Range.of(seeds), carriers, out(), err())
        .print(demos(), app, input, json);
  }

  /** Frames per second of the viewer while b2 runs beside it. */
  private void showView() throws InterruptedException {
    List<Integer> sizes =
        robots == null ? List.of(100, 1000, 10_000) : List.of(robots(0, 2, 1_000_000));
    for (int count : sizes) {
      ViewBench seen =
          ViewBench.take(
              new PatrolWorkload().plan(count, Workload.Style.BLOCKING, Seeds.of(seed)), 1, VIEW_S);
      double simulatedSPerS = seen.simulatedS() / seen.wallS();
      double eventsPerS = seen.events() / seen.wallS();
      Map<String, Object> object = new LinkedHashMap<>();
      object.put("robots", count);
      object.put("framesPerS", seen.framesPerS());
      object.put("cpuMsPerFrame", seen.cpuMs());
      object.put("longestMs", seen.longestMs());
      object.put("simulatedSPerS", simulatedSPerS);
      object.put("traceEventsPerS", eventsPerS);
      String line =
          String.format(
              Locale.ROOT,
              "view n=%d: %.0f frames/s (%.1f CPU ms each, longest wait %.0f ms),"
                  + " %.2f simulated s/s, %.0f trace events/s",
              count,
              seen.framesPerS(),
              seen.cpuMs(),
              seen.longestMs(),
              simulatedSPerS,
              eventsPerS);
      json.print(out(), object, List.of(line));
      out().flush();
    }
  }

  private void showCrossingRules() {
    if (!CrossingRules.hasSumo()) {
      err()
          .println(
              "starl: no rows of SUMO: netconvert and sumo (PyPI: eclipse-sumo) are not on the PATH");
    }
    ProgressLine progress = progress("rows");
    List<Map<String, Object>> rows =
        CrossingRules.take(
            ARRIVALS, Seeds.of(seed), runs(2), done -> progress.show(done, CrossingRules.rows()));
    progress.end();
    print(
        rows,
        "| arrivals/min | faults | rule | arrived | crossed in time/min | mean delay"
            + " | turned away | contacts |",
        "| %d | %s | %s | %d | %.1f | %.1f s | %d | %d |");
  }

  private void showFleetRates() {
    int most = robots(8, 2, 256);
    ProgressLine progress = progress("rows");
    List<Map<String, Object>> rows =
        FleetRates.take(
            most, Seeds.of(seed), runs(1), done -> progress.show(done, FleetRates.rows(most)));
    progress.end();
    print(rows, "| robots | dispatch | faults | deliveries/h |", "| %d | %s | %s | %.0f |");
  }

  private void showCheckSpeed() {
    Carriers.select(null, err());
    int planned = runs(100);
    ProgressLine progress = progress("runs");
    CheckSpeed.Speed speed =
        CheckSpeed.take(planned, Seeds.of(seed), done -> progress.show(done, 3L * planned));
    progress.end();
    String line =
        String.format(
            Locale.ROOT,
            "b5 n=4: %.0f steps/CPU-s, %.1f runs/CPU-s, %.0f simulated s/CPU-s; %d steps a run,"
                + " %d of %d runs violated a specification",
            speed.steps() / speed.cpuS(),
            planned / speed.cpuS(),
            speed.simulatedS() / speed.cpuS(),
            speed.steps() / planned,
            speed.violated(),
            planned);
    json.print(out(), speed.asMap(), List.of(line));
  }

  private void showMutexCost() {
    int most = robots(64, 2, 256);
    int planned = Integer.numberOfTrailingZeros(Integer.highestOneBit(most));
    ProgressLine progress = progress("sizes");
    List<Map<String, Object>> rows =
        MutexCost.take(most, Seeds.of(seed), done -> progress.show(done, planned));
    progress.end();
    print(
        rows,
        "| robots | free: ms to enter (theory) | free: messages an entry (theory)"
            + " | busy: ms to enter, median | most (bound) | busy: messages an entry |",
        "| %d | %.0f (%.0f) | %.1f (%.0f) | %.0f | %.0f (%.0f) | %.1f |");
  }

  /** A table in Markdown, for the docs; or a line of JSON for each row. */
  private void print(List<Map<String, Object>> rows, String head, String format) {
    PrintWriter out = out();
    if (json.isOn()) {
      rows.forEach(row -> out.println(Json.line(row)));
      return;
    }
    out.println(head);
    out.println(head.replaceAll("[^|]+", "---"));
    for (Map<String, Object> row : rows) {
      out.println(String.format(Locale.ROOT, format, row.values().toArray()));
    }
  }

  private static String line(Measurement run) {
    return String.format(
        Locale.ROOT,
        "%s n=%d %s%s: %.2f M events/CPU-s, %.1f simulated s/CPU-s; %.2f CPU s, %.2f wall s,"
            + " %d bytes/robot, %.0f MB",
        run.workload(),
        run.robots(),
        run.style().name().toLowerCase(Locale.ROOT),
        run.coldness() == 0 ? " (cold)" : "",
        run.eventsPerCpuS() / 1e6,
        run.realTimeFactor(),
        run.cpuS(),
        run.wallS(),
        run.bytesPerRobot(),
        run.peakRssMb());
  }
}
