package org.starl.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.Shrink;
import org.starl.sim.check.Trial;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.kernel.CarrierKind;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Shrinks a run of the command line, and says how to run what is left. */
final class Shrinking {

  private static final int MOST_RUNS = 500;

  /** What a {@link Trial} says in a way of its own. */
  private static final Set<Setting<?>> OF_TRIAL =
      Set.of(Setting.ROBOTS, Setting.DURATION, Setting.FAULTS, Setting.CHAOS, Setting.CHAOS_FOR);

  private final Demos demos;
  private final RunRequest whole;
  private final long seed;
  private final CarrierKind carriers;
  private final Trial from;

  /**
   * What is left.
   *
   * @param words of the command that runs it, after {@code ./starl}
   */
  record Shrunk(Trial from, Shrink.Result result, List<String> words) {

    String command() {
      return Shell.starl(words);
    }

    List<String> lines() {
      return List.of(
          "shrunk in "
              + result.runs()
              + " runs: "
              + from
              + " -> "
              + result.trial()
              + (result.isSmallest() ? "" : " (there may be a smaller one)"),
          "seed " + words.get(words.indexOf("--seed") + 1) + ": " + result.outcome().detail(),
          "replay: " + command());
    }

    Map<String, Object> json() {
      Map<String, Object> json = new LinkedHashMap<>();
      json.put("robots", result.trial().robots());
      json.put("faults", result.trial().faults().stream().map(Object::toString).toList());
      json.put("for_s", result.trial().endNs() / 1e9);
      json.put("runs", result.runs());
      json.put("bad", result.outcome().detail());
      json.put("replay", command());
      return json;
    }
  }

  Shrinking(Demos demos, RunRequest chosen, long seed, CarrierKind carriers) {
    this.demos = demos;
    this.seed = seed;
    this.carriers = carriers;
    Plan plan = chosen.plan(seed);
    SimSettings settings = plan.simulation().settings();
    SimSettings kept = chosen.settings();
    if (settings.get(Setting.CHAOS) == Envelope.HOSTILE) {
      // Hostile chaos seals datagrams; its faults alone do not.
      kept = kept.with(Setting.SEALED, true);
    }
    whole = chosen.withSettings(kept);
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

  /** Shrinks, told line by line; then runs the command that it prints, to be sure of it. */
  Shrunk run(PrintWriter err) {
    Shrink shrink =
        new Shrink(
            trial -> outcome(chosen(trial).plan(seed)),
            MOST_RUNS,
            (run, trial, outcome, isKept) ->
                err.println("shrink " + run + ": " + trial + ": " + said(outcome, isKept)));
    Shrink.Result result = shrink.shrink(from);
    List<String> words = new ArrayList<>(List.of("run"));
    words.addAll(chosen(result.trial()).words(seed));
    RunOutcome again = outcome(parsed(words));
    if (!again.equals(result.outcome())) {
      throw new IllegalStateException(
          "'" + String.join(" ", words) + "' ends otherwise: " + again.detail());
    }
    return new Shrunk(from, result, words);
  }

  private static String said(RunOutcome outcome, boolean isKept) {
    String how = outcome.isGood() ? "goes well" : outcome.detail();
    return how + (isKept ? "" : " (not taken)");
  }

  private RunOutcome outcome(Plan plan) {
    try {
      return RunOutcome.of(plan.simulation().carriers(carriers).build().run());
    } catch (RuntimeException e) {
      return RunOutcome.failed(e);
    }
  }

  private RunRequest chosen(Trial trial) {
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

  /** What {@code starl run} makes of these words. */
  private Plan parsed(List<String> words) {
    RunWords run = new RunWords();
    new CommandLine(run).parseArgs(words.subList(1, words.size()).toArray(String[]::new));
    return run.options.chosen(demos).plan(run.seed.value());
  }

  @Command(name = "run")
  private static final class RunWords {
    @Mixin private RunOptions options = new RunOptions();
    @Mixin private SeedOption seed = new SeedOption();
  }
}
