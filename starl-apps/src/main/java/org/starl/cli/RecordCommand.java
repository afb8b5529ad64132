package org.starl.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.sim.SimResult;
import org.starl.sim.input.BadInput;
import org.starl.sim.input.Quantities;
import org.starl.sim.record.Moment;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code starl record}. */
@Command(
    name = "record",
    description = "Runs, and draws a picture of one moment.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl record intersection --seed 7 --png t=12s --out crossing.png"})
final class RecordCommand implements Callable<Integer> {

  private static final String EXPECTED = "expected t=TIME (t=12s), end or best";

  @Mixin private RunOptions options = new RunOptions();

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--png",
      paramLabel = "WHEN",
      description = "t=12s, end, or best: when most is to be seen. best unless given.")
  private String when = "best";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Where the picture goes; out/APP-SEED.png unless given.")
  private @Nullable String file;

  @Spec private @Nullable CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    Moment moment = moment(when);
    Chosen chosen = options.chosen(Main.demos(spec));
    long seedNumber = seed.value();
    Plan plan = chosen.plan(seedNumber);
    String target = file == null ? defaultFile(chosen.demo().name(), seedNumber) : file;
    SimResult result;
    try (Picture picture = new Picture(plan, moment, "--out", target)) {
      plan.simulation().observer(picture.recorder()).carriers(Carriers.chosen(null, err));
      result = plan.simulation().build().run();
    }
    out.println(chosen.demo().name() + ", seed " + seedNumber + ": " + target);
    if (Outcome.isGood(result)) {
      return ExitStatus.GOOD;
    }
    Outcome.complaints(result).forEach(err::println);
    err.println("replay: " + options.replay("run", seedNumber));
    return ExitStatus.VIOLATED;
  }

  static String defaultFile(String app, long seed) {
    return String.format(Locale.ROOT, "out/%s-%d.png", app, seed);
  }

  private static Moment moment(String text) {
    if (text.equals("end")) {
      return new Moment.End();
    }
    if (text.equals("best")) {
      return new Moment.Best();
    }
    if (!text.startsWith("t=")) {
      throw new BadInput("--png: " + BadInput.quote(text) + ": " + EXPECTED);
    }
    try {
      return new Moment.At(Quantities.durationNs(text.substring(2)));
    } catch (BadInput error) {
      throw Quantities.in("--png", error);
    }
  }
}
