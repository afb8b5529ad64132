package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.export.CsvTable;
import org.starl.sim.export.McapRecorder;
import org.starl.sim.record.GifRecorder;
import org.starl.sim.record.PictureTime;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl record}. */
@Command(
    name = "record",
    description =
        "Writes a picture, an animation, an MCAP file or a table of a run. The run is simulated"
            + " now, or read from a trace.",
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Example: starl record intersection --seed 7 --png t=12s --out crossing.png",
      "         starl record intersection --seed 7 --gif --every 500ms",
      "         starl record intersection --seed 7 --mcap",
      "         starl record out/crossing.trace --gif --when violation"
    })
final class RecordCommand extends BaseCommand implements Callable<Integer> {

  private static final String EXPECTED = "expected t=TIME (t=12s), end, best or violation";
  private static final String VIOLATION = "violation";
  private static final int MAX_WIDTH_PX = 4000;
  private static final long NS_PER_MS = 1_000_000;

  /** The kind of output. */
  private static final class Output {
    @Option(
        names = "--png",
        arity = "0..1",
        fallbackValue = "",
        paramLabel = "WHEN",
        description = "A picture (the default).")
    private @Nullable String png;

    @Option(names = "--gif", description = "An animation.")
    private boolean gif;

    @Option(
        names = "--mcap",
        description = "Motion, messages, variables and log, for Foxglove and other tools.")
    private boolean mcap;

    @Option(
        names = "--csv",
        arity = "0..1",
        fallbackValue = "",
        paramLabel = "TABLE",
        description = "A table: positions, messages or variables (default: positions).")
    private @Nullable String csv;
  }

  @Mixin private RunOptions options = new RunOptions();

  @Mixin private SeedOption seed = new SeedOption();

  @ArgGroup private @Nullable Output output;

  @Option(
      names = "--when",
      paramLabel = "WHEN",
      description =
          "The moment of a picture: t=12s, end, best (the moment that shows most) or violation (the"
              + " first one). With --gif only violation: the animation ends with it. Without a"
              + " violation, nothing is written (default: best; with --gif the whole run).")
  private @Nullable String when;

  @Option(
      names = "--every",
      paramLabel = "TIME",
      defaultValue = "250ms",
      description =
          "Simulated time between two frames of an animation (default: ${DEFAULT-VALUE}).")
  private String every = "250ms";

  @Option(
      names = "--width",
      paramLabel = "PIXELS",
      defaultValue = "900",
      description = "Width of an animation in pixels (default: ${DEFAULT-VALUE}).")
  private String width = "900";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "The file to write (default: out/APP-SEED.png, .gif, .mcap or .csv).")
  private @Nullable String file;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = out();
    PrintWriter err = err();
    String suffix = suffix();
    String wanted = when();
    PictureTime moment = moment(wanted);
    Recordable run = run(demos(), err);
    String target = file == null ? defaultFile(run.app(), run.seed(), suffix) : file;
    Recorded recorded =
        switch (suffix) {
          case "gif" -> gif(run, wanted, target);
          case "mcap" ->
              table(run, target, stream -> new McapRecorder(stream, run.plan().obstacles()));
          case "csv" -> csv(run, target);
          default -> png(run, moment, target);
        };
    String name = run.app() + ", seed " + run.seed() + ": ";
    out.println(name + (recorded.isWritten() ? target : "no specification was violated"));
    SimResult result = recorded.result();
    if (Outcome.isGood(result)) {
      return ExitStatus.GOOD;
    }
    Outcome.complaints(result).forEach(err::println);
    err.println("replay: " + run.replay());
    return ExitStatus.VIOLATED;
  }

  private Recordable run(Demos demos, PrintWriter err) {
    if (TraceFile.isTrace(options.what())) {
      options.requireNoneFor(options.what());
      seed.requireNoneFor(options.what());
      return Recordable.of(TraceFile.open(options.what(), demos));
    }
    RunRequest request = options.request(demos);
    long seedNumber = seed.value();
    Plan plan = request.plan(seedNumber);
    plan.simulation().carriers(Carriers.select(null, err));
    RunProgress.of(plan.simulation(), err);
    return Recordable.of(request.demo().name(), seedNumber, plan, request.replay(seedNumber));
  }

  /** The run's result, and whether a file was written. */
  private record Recorded(SimResult result, boolean isWritten) {}

  private static Recorded png(Recordable run, PictureTime moment, String target)
      throws IOException {
    try (Picture picture = new Picture(run.plan(), moment, "--out", target)) {
      SimResult result = run.show().apply(picture.recorder());
      return new Recorded(result, picture.isTaken());
    }
  }

  private Recorded gif(Recordable run, String wanted, String target) throws IOException {
    boolean ofViolation = wanted.equals(VIOLATION);
    if (!ofViolation && when != null) {
      throw new BadInput("--when " + when + ": with --gif, expected violation or no --when");
    }
    GifRecorder recorder =
        new GifRecorder(
            run.plan().obstacles(),
            run.plan().layer(),
            everyNs(),
            (int) Numbers.whole("--width", width, 100, MAX_WIDTH_PX),
            ofViolation);
    try (OutputFile output = new OutputFile("--out", target)) {
      SimResult result = run.show().apply(recorder);
      if (recorder.hasFrames()) {
        recorder.writeGif(output.stream());
      }
      return new Recorded(result, recorder.hasFrames());
    }
  }

  private Recorded csv(Recordable run, String target) throws IOException {
    String wanted = output == null || output.csv == null ? "" : output.csv;
    return switch (wanted) {
      case "", "positions" -> table(run, target, CsvTable::positions);
      case "messages" -> table(run, target, CsvTable::messages);
      case "variables" -> table(run, target, CsvTable::variables);
      default ->
          throw new BadInput(
              "--csv: " + BadInput.quote(wanted) + ": expected positions, messages or variables");
    };
  }

  private static <T extends SimObserver & Closeable> Recorded table(
      Recordable run, String target, Function<OutputStream, T> maker) throws IOException {
    try (ObserverFile output = ObserverFile.of("--out", target, maker)) {
      return new Recorded(run.show().apply(output.observer()), true);
    }
  }

  private String suffix() {
    if (output != null && output.gif) {
      return "gif";
    }
    if (output != null && output.csv != null) {
      return "csv";
    }
    return output != null && output.mcap ? "mcap" : "png";
  }

  /** {@code --png t=12s} is short for {@code --png --when t=12s}. */
  private String when() {
    String png = output == null || output.png == null ? "" : output.png;
    if (!png.isEmpty() && when != null) {
      throw new BadInput("--when: --png gives the moment as well; expected one of the two");
    }
    if (!png.isEmpty()) {
      return png;
    }
    return when == null ? "best" : when;
  }

  private long everyNs() {
    try {
      long everyNs = Quantities.durationNs(every);
      if (everyNs < NS_PER_MS) {
        throw new BadInput(BadInput.quote(every) + ": expected at least 1ms");
      }
      return everyNs;
    } catch (BadInput error) {
      throw Quantities.in("--every", error);
    }
  }

  static String defaultFile(String app, long seed, String suffix) {
    return String.format(Locale.ROOT, "out/%s-%d.%s", app, seed, suffix);
  }

  private static PictureTime moment(String text) {
    switch (text) {
      case "end" -> {
        return new PictureTime.End();
      }
      case "best" -> {
        return new PictureTime.Best();
      }
      case VIOLATION -> {
        return new PictureTime.Violation();
      }
      default -> {
        if (!text.startsWith("t=")) {
          throw new BadInput("--png: " + BadInput.quote(text) + ": " + EXPECTED);
        }
      }
    }
    try {
      return new PictureTime.At(Quantities.durationNs(text.substring(2)));
    } catch (BadInput error) {
      throw Quantities.in("--png", error);
    }
  }
}
