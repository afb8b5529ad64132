package org.starl.cli.campaign;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Shell;
import org.starl.cli.command.UntilStopped;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.Shrink;
import org.starl.sim.check.Trial;
import org.starl.sim.explore.Bounds;
import org.starl.sim.explore.Copy;
import org.starl.sim.explore.Why;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.view.page.SequenceChart;
import org.starl.time.Time;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Shrinks a bad run, and gives the command line of the smaller one. */
final class Shrinking {

  private static final int MOST_RUNS = 500;
  private static final int MOST_WHY_RUNS = 200;
  private static final long WHY_BEFORE_NS = 5 * Time.NS_PER_S;

  /** Settings that a {@link Trial} has as values of its own. */
  private static final Set<Setting<?>> OF_TRIAL =
      Set.of(Setting.ROBOTS, Setting.DURATION, Setting.FAULTS, Setting.CHAOS, Setting.CHAOS_FOR);

  private final Demos demos;
  private final RunRequest whole;
  private final long seed;
  private final CarrierKind carriers;
  private final Trial from;

  /**
   * The shrunk run.
   *
   * @param words of its command line, after {@code ./starl}
   * @param twin the command line of the run before, without the faults that are its cause; empty if
   *     there are none
   * @param why single changes that avoid the failure, in lines
   * @param chart a message sequence chart of its last events, as SVG
   */
  record Shrunk(
      Trial from,
      Shrink.Result result,
      List<String> words,
      List<String> twin,
      List<String> why,
      String chart) {

    String command() {
      return Shell.starl(words);
    }

    List<String> lines() {
      List<String> lines = new ArrayList<>();
      lines.add(
          "shrunk in %s runs: %s -> %s%s"
              .formatted(
                  result.runs(),
                  from,
                  result.trial(),
                  result.isSmallest() ? "" : " (a smaller one may exist)"));
      lines.add(
          "seed " + words.get(words.indexOf("--seed") + 1) + ": " + result.outcome().detail());
      lines.add("replay: " + command());
      if (!twin.isEmpty()) {
        lines.add(
            "cause: "
                + causes()
                + ": without "
                + (result.cause().size() == 1 ? "it" : "them")
                + " the run is good: "
                + Shell.starl(twin));
      }
      lines.addAll(why);
      return lines;
    }

    private String causes() {
      return String.join(", ", result.cause().stream().map(Fault::toString).toList());
    }

    Map<String, Object> json() {
      Map<String, Object> json = new LinkedHashMap<>();
      json.put("robots", result.trial().robots());
      json.put("faults", result.trial().faults().stream().map(Object::toString).toList());
      json.put("for_s", Time.seconds(result.trial().endNs()));
      json.put("runs", result.runs());
      json.put("bad", result.outcome().detail());
      json.put("replay", command());
      if (!twin.isEmpty()) {
        json.put("cause", result.cause().stream().map(Object::toString).toList());
        json.put("good_twin", Shell.starl(twin));
      }
      json.put("why", why);
      return json;
    }
  }

  Shrinking(Demos demos, RunRequest request, long seed, CarrierKind carriers) {
    this.demos = demos;
    this.seed = seed;
    this.carriers = carriers;
    Plan plan = request.plan(seed);
    SimSettings settings = plan.simulation().settings();
    RunRequest varied = request.varied(seed);
    SimSettings kept = varied.settings();
    if (settings.get(Setting.CHAOS) == Envelope.HOSTILE) {
      // Hostile chaos also seals datagrams; its faults alone would not.
      kept = kept.with(Setting.SEALED, true);
    }
    whole = varied.withSettings(kept);
    Simulation simulation = plan.simulation().build();
    from =
        new Trial(
            simulation.plan().robots().size(),
            kept.given().keySet().stream()
                .filter(setting -> !OF_TRIAL.contains(setting))
                .map(Setting::key)
                .toList(),
            simulation.faults().faults(),
            settings.endNs());
  }

  /** Shrinks the run, with a line for each trial; then checks the printed command by running it. */
  Shrunk run(BaseCommand command) throws InterruptedException {
    Shrink.Result result = shrunk(command.err(), command.stop());
    List<String> words = new ArrayList<>(List.of("run"));
    words.addAll(request(result.trial()).words(seed));
    Plan plan = parsed(words);
    SequenceChart chart = new SequenceChart();
    plan.simulation().observer(chart);
    RunOutcome again = outcome(plan, result.trial());
    chart.end(again.detail());
    if (!again.equals(result.outcome())) {
      throw new IllegalStateException(
          "'" + String.join(" ", words) + "' ends differently: " + again.detail());
    }
    List<String> why = command.stop().isStopped() ? List.of() : why(result);
    return new Shrunk(from, result, words, twin(result.cause()), why, chart.svg());
  }

  private List<String> twin(List<Fault> cause) {
    if (cause.isEmpty()) {
      return List.of();
    }
    List<Fault> left = new ArrayList<>(from.faults());
    cause.forEach(left::remove);
    List<String> words = new ArrayList<>(List.of("run"));
    words.addAll(
        request(new Trial(from.robots(), from.settings(), left, from.endNs())).words(seed));
    return words;
  }

  /** The smallest run, or the smallest up to a signal. */
  private Shrink.Result shrunk(PrintWriter err, UntilStopped stop) {
    stop.endsWhenAsked();
    return new Shrink(
            trial -> outcome(request(trial).plan(seed), trial),
            MOST_RUNS,
            stop::isStopped,
            (run, trial, outcome, isKept) ->
                err.println("shrink " + run + ": " + trial + ": " + text(outcome, isKept)))
        .shrink(from);
  }

  private List<String> why(Shrink.Result result) throws InterruptedException {
    long atNs = result.outcome().atNs();
    if (atNs < 0) {
      return List.of();
    }
    // Why changes the arrivals of single copies alone.
    Bounds bounds = Bounds.ofDelays(Math.max(0, atNs - WHY_BEFORE_NS), 0);
    RunRequest request = request(result.trial());
    Why why =
        Why.of(
            bounds,
            atNs,
            (schedule, order) -> {
              Plan plan = request.withFaults(schedule).plan(seed);
              plan.simulation().observer(order);
              return outcome(plan, result.trial());
            },
            MOST_WHY_RUNS);
    List<String> lines = new ArrayList<>();
    lines.add(
        why.cures().isEmpty()
            ? "why: none of %d changes of one datagram in the %s before avoids it"
                .formatted(why.tried(), Quantities.durationText(WHY_BEFORE_NS))
            : "why: it does not happen if");
    for (Why.Cure cure : why.cures()) {
      Copy copy = cure.copy();
      lines.add(
          "  %s's datagram %d to %s%s %s"
              .formatted(
                  copy.from(),
                  copy.datagram(),
                  copy.to(),
                  cure.message().isEmpty() ? "" : " (" + cure.message() + ")",
                  cure.isLoss()
                      ? "is lost, which arrived at " + Time.text(copy.arrivesAtNs(), 3)
                      : "arrives at "
                          + Time.text(cure.arrivesAtNs(), 3)
                          + ", not at "
                          + Time.text(copy.arrivesAtNs(), 3)));
      lines.add("    then: " + request.withFaults(List.of(cure.change())).replay(seed));
    }
    return lines;
  }

  private static String text(RunOutcome outcome, boolean isKept) {
    String how = outcome.isGood() ? "good" : outcome.detail();
    return how + (isKept ? "" : " (discarded)");
  }

  private RunOutcome outcome(Plan plan, Trial trial) {
    try {
      Simulation simulation = plan.simulation().carriers(carriers).build();
      if (trial.robots() < from.robots() && simulation.plan().robots().size() >= from.robots()) {
        return RunOutcome.failed(new BadInput("--robots changes nothing in this app"));
      }
      return RunOutcome.of(simulation.run());
    } catch (RuntimeException e) {
      return RunOutcome.failed(e);
    }
  }

  private RunRequest request(Trial trial) {
    SimSettings.Builder settings =
        whole.settings().only(setting -> trial.settings().contains(setting.key())).toBuilder();
    settings.duration(Duration.ofNanos(trial.endNs()));
    if (!trial.faults().isEmpty()) {
      settings.set(Setting.FAULTS, new FaultPlan(trial.faults()));
    }
    if (trial.robots() != from.robots()) {
      settings.robots(trial.robots());
    } else if (whole.robots().isPresent()) {
      settings.robots(whole.robots().getAsInt());
    }
    return whole.withSettings(settings.build());
  }

  /** The plan that {@code starl run} makes from these words. */
  private Plan parsed(List<String> words) {
    RunWords run = new RunWords();
    new CommandLine(run).parseArgs(words.subList(1, words.size()).toArray(String[]::new));
    return run.options.request(demos).plan(run.seed.value());
  }

  @Command(name = "run")
  private static final class RunWords {
    @Mixin private RunOptions.OfApp options = new RunOptions.OfApp();
    @Mixin private SeedOption seed = new SeedOption();
  }
}
