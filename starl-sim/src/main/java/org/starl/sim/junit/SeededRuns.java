package org.starl.sim.junit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.Failure;
import org.starl.sim.Setting;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;
import org.starl.sim.TraceRecorder;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.CampaignResult;
import org.starl.sim.check.RunArtifacts;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.explore.Bounds;
import org.starl.sim.explore.Exploration;
import org.starl.sim.explore.Explorer;
import org.starl.sim.explore.Strategy;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.junit.RunFiles.BadRun;
import org.starl.trace.TraceEvent;
import org.starl.trace.Vocabulary;

/**
 * The runs of one test, for consecutive seeds.
 *
 * @param name of the test, in the format of Maven's {@code -Dtest}
 * @param cell what these runs have in common
 * @param faults of every run, in addition to those of the scenario
 * @param chaos envelope to draw from; {@link Envelope#NONE} for the scenario's own
 * @param atMostNs end of runs whose scenario sets no end
 * @param schedules to explore for each seed, if all runs went well
 * @param files where a bad run is written
 * @param scenario the test's method
 */
record SeededRuns(
    String name,
    Cell cell,
    FaultPlan faults,
    Envelope chaos,
    long atMostNs,
    int schedules,
    RunFiles files,
    Scenario scenario) {

  /** The maximum number of bad runs in the failure message. */
  private static final int MOST_REPORTED = 5;

  private static final int CHANGES = 3;

  /** Configures the builder of one seed, and declares the checks. */
  @FunctionalInterface
  interface Scenario {
    void fill(long seed, Simulation.Builder simulation, List<Consumer<SimResult>> checks);
  }

  /** One run: written by its thread, read after all runs. */
  private static final class Run {
    private final long seed;
    private final List<Fault> schedule;
    private final Simulation simulation;
    private final List<Consumer<SimResult>> checks;
    private @Nullable SimResult result;
    private @Nullable Throwable error;

    Run(long seed, List<Fault> schedule, Simulation simulation, List<Consumer<SimResult>> checks) {
      this.seed = seed;
      this.schedule = schedule;
      this.simulation = simulation;
      this.checks = checks;
    }

    RunOutcome go() {
      try {
        SimResult mine = simulation.run();
        result = mine;
        return RunOutcome.of(mine);
      } catch (RuntimeException e) {
        error = e;
        return RunOutcome.failed(e);
      }
    }
  }

  /**
   * @param atNs time of the failure, in ns of virtual time; -1 if unknown
   */
  private record Bad(Run run, String what, long atNs) {}

  /**
   * Executes all runs.
   *
   * @throws AssertionError if a run is bad
   * @throws InterruptedException if the test's thread is interrupted
   */
  void run(long firstSeed, long lastSeed) throws InterruptedException {
    Campaign campaign = new Campaign(firstSeed, lastSeed);
    List<Run> runs = new ArrayList<>();
    for (long seed = firstSeed; seed <= lastSeed; seed++) {
      runs.add(planned(seed, List.of()));
    }
    List<Bad> bad = new ArrayList<>();
    CampaignResult result =
        campaign.run(seed -> runs.get((int) (seed - firstSeed)).go(), (done, planned, soFar) -> {});
    result
        .runs()
        .forEach(finished ->
            judge(runs.get((int) (finished.seed() - firstSeed)), finished.outcome(), bad));
    for (Run run : runs) {
      if (bad.isEmpty() && schedules > 0) {
        explore(run, bad);
      }
    }
    if (!bad.isEmpty()) {
      throw new AssertionError(report(bad, runs.size()), bad.get(0).run().error);
    }
    if (result.leavesUnchecked()) {
      throw new AssertionError(
          title() + ": never checked in " + runs.size() + " runs: " + result.neverChecked());
    }
  }

  /** Runs the seed with other orders of its events. */
  private void explore(Run run, List<Bad> bad) throws InterruptedException {
    long seed = run.seed;
    long drawnNs = run.simulation.plan().settings().get(Setting.MESSAGE_DELAY).longestNs();
    Exploration exploration =
        new Exploration(Strategy.PCT, CHANGES, seed, schedules, Bounds.ofDelays(0, drawnNs));
    Explorer explorer =
        new Explorer(
            exploration,
            (schedule, order) -> {
              List<Bad> wrong = new ArrayList<>();
              Run other = planned(seed, schedule, order);
              RunOutcome outcome = other.go();
              judge(other, outcome, wrong);
              return wrong.isEmpty() || !outcome.isGood()
                  ? outcome
                  : RunOutcome.failed(new IllegalStateException(wrong.get(0).what()));
            });
    Explorer.Found found = explorer.run().found();
    if (found != null) {
      Run again = planned(seed, found.schedule());
      judge(again, again.go(), bad);
    }
  }

  // On several threads at once while schedules are explored: the method of the test is called by
  // one of them at a time.
  private synchronized Run planned(long seed, List<Fault> schedule, SimObserver... observers) {
    Simulation.Builder builder = Simulation.builder().name(name).seed(seed);
    List.of(observers).forEach(builder::observer);
    List<Consumer<SimResult>> checks = new ArrayList<>();
    try {
      return planned(seed, schedule, builder, checks);
    } catch (AssertionError | RuntimeException wrong) {
      // Rethrown unchanged, because JUnit handles some types; the seed is added as suppressed.
      wrong.addSuppressed(new IllegalStateException("seed " + seed + "; " + replay(seed)));
      throw wrong;
    }
  }

  private Run planned(
      long seed,
      List<Fault> schedule,
      Simulation.Builder builder,
      List<Consumer<SimResult>> checks) {
    builder.settings(cell.over(builder.settings()));
    scenario.fill(seed, builder, checks);
    SimSettings.Builder settings = builder.settings().toBuilder();
    if (!builder.settings().has(Setting.DURATION)) {
      settings.duration(Duration.ofNanos(atMostNs));
    }
    if (chaos != Envelope.NONE) {
      settings.set(Setting.CHAOS, chaos);
    }
    FaultPlan all = faults.plus(new FaultPlan(schedule));
    Simulation simulation =
        builder
            .settings(settings.build())
            .faults(all)
            .commands(() -> List.of(replay(seed)))
            .build();
    requireARun(seed, simulation.plan());
    return new Run(seed, schedule, simulation, checks);
  }

  private void requireARun(long seed, SimulationPlan plan) {
    if (plan.header().scenarioSeed() != seed) {
      throw new BadInput(
          name
              + ": the method sets seed "
              + plan.header().scenarioSeed()
              + ", so every run would be the same: delete that call; a parameter of type long is"
              + " the seed of the run");
    }
    if (plan.robots().isEmpty() && plan.director() == null) {
      throw new BadInput(
          name + ": a simulation without robots: expected a call of robots(...) or robot(...)");
    }
  }

  private static void judge(Run run, RunOutcome outcome, List<Bad> bad) {
    SimResult result = run.result;
    if (!outcome.isGood() || result == null) {
      bad.add(new Bad(run, outcome.detail(), outcome.atNs()));
      return;
    }
    try {
      run.checks.forEach(check -> check.accept(result));
    } catch (AssertionError | RuntimeException e) {
      run.error = e;
      bad.add(new Bad(run, String.valueOf(e.getMessage()).strip(), result.endNs()));
    }
  }

  private String report(List<Bad> bad, int runs) throws InterruptedException {
    List<String> lines = new ArrayList<>();
    lines.add(title() + ": " + bad.size() + " of " + runs + " runs went wrong");
    for (Bad each : bad.subList(0, Math.min(bad.size(), MOST_REPORTED))) {
      lines.add("  seed " + each.run().seed + ": " + each.what());
    }
    if (bad.size() > MOST_REPORTED) {
      lines.add("  and " + (bad.size() - MOST_REPORTED) + " more");
    }
    Run first = bad.get(0).run();
    FaultPlan allFaults = first.simulation.faults();
    if (!allFaults.isEmpty()) {
      lines.add("faults of seed " + first.seed + ": " + allFaults);
    }
    SimResult result = first.result;
    if (result != null) {
      Failure failure = result.failure();
      if (failure != null) {
        failure.facts().forEach(line -> lines.add("  " + line));
      }
      result.diagnosis().details().forEach(line -> lines.add("  " + line));
      result
          .diagnoses()
          .forEach((violation, diagnosis) -> {
            String was = violation.isOverdue() ? " was overdue:" : " was violated:";
            lines.add("when " + violation.lemma() + was);
            diagnosis.lines().forEach(line -> lines.add("  " + line));
          });
    }
    Optional<RunArtifacts> viewer = RunArtifacts.installed();
    lines.addAll(filesOf(bad.get(0), viewer));
    lines.add(replay(first.seed));
    if (viewer.isPresent()) {
      lines.add("watch: " + command(first.seed) + " -D" + RunFiles.VIEW + "=true");
    }
    return String.join("\n", lines);
  }

  /** Repeats a bad run to write the files that show it; the lines name them. */
  private List<String> filesOf(Bad bad, Optional<RunArtifacts> viewer) throws InterruptedException {
    long seed = bad.run().seed;
    List<String> lines = new ArrayList<>();
    try {
      Path trace = files.trace(name, seed);
      BadRun run = writeTrace(bad, trace);
      lines.add("trace: " + trace);
      lines.addAll(files.draw(viewer, run));
      files.showIfAsked(viewer, run, bad.atNs());
    } catch (IOException e) {
      lines.add("the run of seed " + seed + " cannot be shown: " + e.getMessage());
    }
    return lines;
  }

  private BadRun writeTrace(Bad bad, Path trace) throws IOException {
    EventShapes shapes = new EventShapes();
    try (TraceRecorder recorder = new TraceRecorder(Files.newOutputStream(trace))) {
      Run run = planned(bad.run().seed, bad.run().schedule, recorder, shapes);
      run.go();
      return new BadRun(trace, shapes.vocabulary, run.simulation.plan(), bad.what());
    }
  }

  /** Collects the shapes of a run's values, which a reader of its trace needs. */
  private static final class EventShapes implements SimObserver {
    private Vocabulary vocabulary = Vocabulary.NONE;

    @Override
    public void observed(TraceEvent event) {
      vocabulary = vocabulary.with(event);
    }
  }

  private String replay(long seed) {
    return "replay: " + command(seed);
  }

  private String title() {
    return cell.isEmpty() ? name : name + " with " + cell;
  }

  private String command(long seed) {
    String only = cell.isEmpty() ? "" : " '-D" + StarlExtension.CELL + "=" + cell + "'";
    return "mvn test '-Dtest=" + name + "' -D" + StarlExtension.SEED + "=" + seed + only;
  }
}
