package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.export.McapRecorder;
import org.starl.sim.export.MessageTable;
import org.starl.sim.export.PositionTable;
import org.starl.sim.export.VariableTable;
import org.starl.sim.record.GifRecorder;
import org.starl.sim.record.Moment;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code starl record}. */
@Command(
    name = "record",
    description = {
      "Writes a picture of one moment, a moving picture, an MCAP file or a table of a run:",
      "of one that is simulated now, or, without simulating, of one in a trace."
    },
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Example: starl record intersection --seed 7 --png t=12s --out crossing.png",
      "         starl record intersection --seed 7 --gif --every 500ms",
      "         starl record intersection --seed 7 --mcap",
      "         starl record out/crossing.trace --gif --when violation"
    })
final class RecordCommand implements Callable<Integer> {

  private static final String EXPECTED = "expected t=TIME (t=12s), end, best or violation";
  private static final String VIOLATION = "violation";
  private static final int MAX_WIDTH_PX = 4000;
  private static final long NS_PER_MS = 1_000_000;

  /** What is written. */
  private static final class What {
    @Option(
        names = "--png",
        arity = "0..1",
        fallbackValue = "",
        paramLabel = "WHEN",
        description = "A picture; this is what is written unless something else is said.")
    private @Nullable String png;

    @Option(names = "--gif", description = "A moving picture.")
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
        description = "A table of positions (unless said otherwise), messages or variables.")
    private @Nullable String csv;
  }

  @Mixin private RunOptions options = new RunOptions();

  @Mixin private SeedOption seed = new SeedOption();

  @ArgGroup private @Nullable What what;

  @Option(
      names = "--when",
      paramLabel = "WHEN",
      description =
          "Of pictures: t=12s, end, best (when most is to be seen), or violation (the first, with"
              + " what came before in a moving picture; nothing is written if there is none).")
  private @Nullable String when;

  @Option(
      names = "--every",
      paramLabel = "TIME",
      description = "Virtual time between two frames of a moving picture; 250ms unless given.")
  private String every = "250ms";

  @Option(
      names = "--width",
      paramLabel = "PIXELS",
      description = "Of a moving picture; 900 unless given.")
  private String width = "900";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "What to write to; out/APP-SEED.png, .gif, .mcap or .csv unless given.")
  private @Nullable String file;

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    String suffix = suffix();
    String wanted = when();
    Moment moment = moment(wanted);
    Recordable run = run(Main.demos(spec), err);
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
    err.println("replay: " + run.again());
    return ExitStatus.VIOLATED;
  }

  private Recordable run(Demos demos, PrintWriter err) {
    if (TraceFile.isOne(options.what())) {
      options.requireNoneFor(options.what());
      seed.requireNoneFor(options.what());
      return Recordable.of(TraceFile.open(options.what(), demos));
    }
    RunRequest chosen = options.chosen(demos);
    long seedNumber = seed.value();
    Plan plan = chosen.plan(seedNumber);
    plan.simulation().carriers(Carriers.chosen(null, err));
    RunProgress.of(plan.simulation(), err);
    return Recordable.of(chosen.demo().name(), seedNumber, plan, chosen.replay(seedNumber));
  }

  /** How the run went, and whether there was anything to write. */
  private record Recorded(SimResult result, boolean isWritten) {}

  private static Recorded png(Recordable run, Moment moment, String target) throws IOException {
    try (Picture picture = new Picture(run.plan(), moment, "--out", target)) {
      SimResult result = run.show().apply(picture.recorder());
      return new Recorded(result, picture.isTaken());
    }
  }

  private Recorded gif(Recordable run, String wanted, String target) throws IOException {
    boolean ofViolation = wanted.equals(VIOLATION);
    if (!ofViolation && when != null) {
      throw new BadInput("--when " + when + ": of a moving picture, expected violation or nothing");
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
    String wanted = what == null || what.csv == null ? "" : what.csv;
    return switch (wanted) {
      case "", "positions" -> table(run, target, PositionTable::new);
      case "messages" -> table(run, target, MessageTable::new);
      case "variables" -> table(run, target, VariableTable::new);
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
    if (what != null && what.gif) {
      return "gif";
    }
    if (what != null && what.csv != null) {
      return "csv";
    }
    return what != null && what.mcap ? "mcap" : "png";
  }

  /** {@code --png t=12s} is short for {@code --png --when t=12s}. */
  private String when() {
    String png = what == null || what.png == null ? "" : what.png;
    if (!png.isEmpty() && when != null) {
      throw new BadInput("--when: the moment is given by --png as well; expected one of the two");
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

  private static Moment moment(String text) {
    switch (text) {
      case "end" -> {
        return new Moment.End();
      }
      case "best" -> {
        return new Moment.Best();
      }
      case VIOLATION -> {
        return new Moment.Violation();
      }
      default -> {
        if (!text.startsWith("t=")) {
          throw new BadInput("--png: " + BadInput.quote(text) + ": " + EXPECTED);
        }
      }
    }
    try {
      return new Moment.At(Quantities.durationNs(text.substring(2)));
    } catch (BadInput error) {
      throw Quantities.in("--png", error);
    }
  }
}
