package org.starl.cli.run;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.OutputFile;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.cli.request.TraceFile;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.export.CsvTable;
import org.starl.sim.export.FoxgloveLayout;
import org.starl.sim.export.McapRecorder;
import org.starl.sim.export.TakeTable;
import org.starl.sim.record.AnimationRecorder;
import org.starl.sim.record.PictureTime;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.RunPage;
import org.starl.time.Time;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code starl record}. */
@Command(
    name = "record",
    description =
        "Writes a picture, an animation, an HTML page, an MCAP file or a table of a run. The run is"
            + " simulated now, or read from a trace.",
    footer = {
      "",
      "Example: starl record intersection --seed 7 --png t=12s --out crossing.png",
      "         starl record intersection --seed 7 --gif --every 500ms",
      "         starl record intersection --seed 7 --html crossing.html",
      "         starl record intersection --seed 7 --mcap",
      "         starl record intersection --seed 7 --rosbag --out crossing",
      "         starl record out/crossing.trace --gif --when violation"
    })
public final class RecordCommand extends BaseCommand implements Callable<Integer> {

  private static final String VIOLATION = "violation";
  private static final int MAX_WIDTH_PX = 4000;
  private static final String BAG = "run.mcap";
  private static final String LAYOUT = ".foxglove-layout.json";

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

    @Option(names = "--mp4", description = "An animation as video (H.264).")
    private boolean mp4;

    @Option(
        names = "--html",
        arity = "0..1",
        fallbackValue = "",
        paramLabel = "FILE",
        description = "A page that plays the run in a browser.")
    private @Nullable String html;

    @Option(
        names = "--mcap",
        description = "Motion, messages, variables and log, for Foxglove and other tools.")
    private boolean mcap;

    @Option(
        names = "--rosbag",
        description =
            "The same with messages of ROS 2: a folder that 'ros2 bag play' and PlotJuggler read.")
    private boolean rosbag;

    @Option(
        names = "--csv",
        arity = "0..1",
        fallbackValue = "",
        paramLabel = "TABLE",
        description =
            "A table: positions, messages, variables, or take, true poses as OptiTrack's Motive"
                + " exports them (default: positions).")
    private @Nullable String csv;
  }

  @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private SpecsOption specs = new SpecsOption();

  @ArgGroup private @Nullable Output output;

  @Option(
      names = "--when",
      paramLabel = "WHEN",
      description =
          "The moment of a picture: t=12s, end, best (the moment that shows most) or violation (the"
              + " first one). With --gif or --mp4 only violation: the animation ends with it. Without a"
              + " violation, nothing is written (default: best; an animation has the whole run). With"
              + " --html none: a page has the whole run.")
  private @Nullable String when;

  @Option(
      names = "--every",
      paramLabel = "TIME",
      description =
          "Simulated time between two frames of an animation (default: 250ms; with --html 100ms).")
  private @Nullable String every;

  @Option(
      names = "--width",
      paramLabel = "PIXELS",
      defaultValue = "900",
      description = "Width of an animation in pixels (default: ${DEFAULT-VALUE}).")
  private String width = "900";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description =
          "The file to write (default: out/APP-SEED.png, .gif, .mp4, .html, .mcap, .rosbag or .csv; with settings,"
              + " a number that depends on them follows SEED).")
  private @Nullable String file;

  @Override
  public Integer call() throws IOException {
    String suffix = suffix();
    String wanted = when();
    PictureTime moment =
        OptionValues.read(when == null ? "--png" : "--when", wanted, RecordCommand::moment);
    String named = fileName();
    if (named != null && !suffix.equals("rosbag")) {
      OutputFile.requireEnding(file == null ? "--html" : "--out", named, suffix);
    }
    Source source = source();
    String target = named == null ? source.request().file(source.seed(), suffix) : named;
    ObserverFile written =
        switch (suffix) {
          case "gif", "mp4" -> animation(source.plan(), wanted, target, suffix);
          case "html" -> html(source.plan(), target);
          case "mcap" -> mcap(source.plan(), target, false);
          case "rosbag" -> mcap(source.plan(), target + "/" + BAG, true);
          case "csv" -> csv(target);
          default -> ObserverFile.picture("--out", target, source.plan(), moment);
        };
    String layout = suffix.equals("mcap") ? target.replaceFirst("(\\.mcap)?$", LAYOUT) : "";
    String second = suffix.equals("rosbag") ? target + "/metadata.yaml" : layout;
    SimResult result;
    try (written;
        OutputFile beside = second.isEmpty() ? null : new OutputFile("--out", second)) {
      result = show(source, written.observer());
      if (beside != null) {
        beside.stream()
            .write(
                written.observer() instanceof McapRecorder bag && layout.isEmpty()
                    ? bag.metadata(BAG).getBytes(StandardCharsets.UTF_8)
                    : FoxgloveLayout.json());
      }
    }
    String name = source.request().demo().name() + ", seed " + source.seed() + ": ";
    out().println(name + (written.isWritten() ? target : "no specification was violated"));
    if (!layout.isEmpty()) {
      out().println("layout for Foxglove: " + layout);
    }
    if (moment instanceof PictureTime.At at && at.timeNs() > result.endNs()) {
      err()
          .println(
              "%s: the run ended before, at %s; the picture shows its end"
                  .formatted(wanted, Time.text(result.endNs(), 1)));
    }
    Outcome.leftOut(result.spec()).forEach(out()::println);
    if (Outcome.isGood(result)) {
      return ExitStatus.GOOD;
    }
    Outcome.complaints(result).forEach(err()::println);
    err().println("replay: " + source.replay());
    return ExitStatus.VIOLATED;
  }

  /**
   * A run to record: a simulation, or a trace.
   *
   * @param plan of the run, with the obstacles and the layer for its pictures
   * @param show shows the run to an observer; call once
   * @param replay the command line that shows the run again
   */
  private record Source(
      RunRequest request,
      long seed,
      Plan plan,
      Function<SimObserver, SimResult> show,
      String replay) {}

  private static SimResult show(Source source, SimObserver observer) {
    try {
      return source.show().apply(observer);
    } catch (RuntimeException e) {
      if (observer instanceof Recording recording) {
        recording.failed(RunOutcome.failed(e).detail());
      }
      throw e;
    }
  }

  private Source source() {
    return TraceFile.isTrace(options.name()) ? ofTrace() : ofSimulation();
  }

  /** The trace must be complete, so that no file of a broken trace is written. */
  private Source ofTrace() {
    options.requireNoneFor(options.name());
    seed.requireNoneFor(options.name());
    specs.requireNoneFor("a trace: " + options.name());
    TraceFile trace = TraceFile.open(options.name(), demos());
    trace.requireWhole();
    return new Source(
        trace.request(),
        trace.header().scenarioSeed(),
        trace.plan(),
        observer -> trace.show(List.of(observer)),
        trace.again());
  }

  private Source ofSimulation() {
    RunRequest request = options.request(demos());
    long seedNumber = seed.value();
    Plan plan = request.plan(seedNumber);
    specs.apply(plan.simulation());
    request.unusedRobots(seedNumber).ifPresent(err()::println);
    plan.simulation().carriers(Carriers.select(null, err()));
    RunProgress.of(plan.simulation(), this);
    return new Source(
        request,
        seedNumber,
        plan,
        observer -> plan.simulation().observer(observer).build().run(),
        request.replay(seedNumber));
  }

  private ObserverFile animation(Plan plan, String wanted, String target, String suffix) {
    boolean ofViolation = wanted.equals(VIOLATION);
    if (!ofViolation && when != null) {
      throw new BadInput(
          "--when %s cannot be used with --%s; expected --when violation, or no --when"
              .formatted(when, suffix));
    }
    long everyNs =
        OptionValues.read("--every", every == null ? "250ms" : every, RecordCommand::everyNs);
    int widthPx = OptionValues.whole("--width", width, 100, MAX_WIDTH_PX);
    return streamed(
        target,
        out ->
            new AnimationRecorder(
                suffix.equals("gif") ? AnimationRecorder.Kind.GIF : AnimationRecorder.Kind.MP4,
                out,
                plan.obstacles(),
                plan.layer(),
                everyNs,
                widthPx,
                ofViolation));
  }

  private ObserverFile html(Plan plan, String target) {
    if (when != null) {
      throw new BadInput("--when " + when + ": with --html, expected no --when");
    }
    long everyNs = every == null ? 0 : OptionValues.read("--every", every, RecordCommand::everyNs);
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    return ObserverFile.after(
        "--out",
        target,
        recording,
        out -> {
          RunPage page =
              every == null
                  ? new RunPage(recording)
                  : new RunPage(recording, everyNs, 0, Long.MAX_VALUE);
          page.write(out);
        });
  }

  private static ObserverFile mcap(Plan plan, String target, boolean isRos) {
    return streamed(
        target, out -> new McapRecorder(out, plan.obstacles(), plan.layer().copy(), isRos));
  }

  private ObserverFile csv(String target) {
    String wanted = output == null || output.csv == null ? "" : output.csv;
    return switch (wanted) {
      case "", "positions" -> streamed(target, CsvTable::positions);
      case "messages" -> streamed(target, CsvTable::messages);
      case "variables" -> streamed(target, CsvTable::variables);
      case "take" -> streamed(target, TakeTable::new);
      default ->
          throw new BadInput(
              "--csv: "
                  + BadInput.quote(wanted)
                  + ": expected positions, messages, variables or take");
    };
  }

  private static <T extends SimObserver & Closeable> ObserverFile streamed(
      String target, Function<OutputStream, T> maker) {
    return ObserverFile.of("--out", target, maker);
  }

  private String suffix() {
    if (output == null) {
      return "png";
    }
    if (output.html != null) {
      return "html";
    }
    return output.gif
        ? "gif"
        : output.mp4
            ? "mp4"
            : output.csv != null ? "csv" : output.mcap ? "mcap" : output.rosbag ? "rosbag" : "png";
  }

  /** {@code --html FILE} is short for {@code --html --out FILE}. */
  private @Nullable String fileName() {
    String html = output == null || output.html == null ? "" : output.html;
    if (html.isEmpty()) {
      return file;
    }
    if (file != null) {
      throw new BadInput("--out: --html names the file as well; expected one of the two");
    }
    return html;
  }

  /** {@code --png t=12s} is short for {@code --png --when t=12s}. */
  private String when() {
    String png = output == null || output.png == null ? "" : output.png;
    if (!png.isEmpty() && when != null) {
      throw new BadInput("--when: --png has a moment too; expected only one of the two");
    }
    if (!png.isEmpty()) {
      return png;
    }
    return when == null ? "best" : when;
  }

  private static long everyNs(String text) {
    long everyNs = Quantities.durationNs(text);
    if (everyNs < Time.NS_PER_MS) {
      throw new BadInput(BadInput.quote(text) + ": expected at least 1ms");
    }
    return everyNs;
  }

  private static PictureTime moment(String text) {
    return switch (text) {
      case "end" -> new PictureTime.End();
      case "best" -> new PictureTime.Best();
      case VIOLATION -> new PictureTime.Violation();
      default -> {
        if (!text.startsWith("t=")) {
          throw new BadInput(
              BadInput.quote(text) + ": expected t=TIME (t=12s), end, best or violation");
        }
        yield new PictureTime.At(Quantities.durationNs(text.substring(2)));
      }
    };
  }
}
