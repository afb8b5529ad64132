package org.starl.primitives.specimen;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.geocast.GeocastConformance;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.mutex.MutexConformance;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.specimen.SetMutex.Bug;
import org.starl.sim.Setting;
import org.starl.sim.SimObserver;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.check.Shrink;
import org.starl.sim.check.Trial;
import org.starl.sim.explore.Bounds;
import org.starl.sim.explore.Exploration;
import org.starl.sim.explore.Explorer;
import org.starl.sim.explore.Strategy;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultPlan;
import org.starl.spec.Monitor;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * Bugs that the original StarL had, written anew from their description, on whole simulated robots
 * in a network that does whatever a network may do: each is caught by our specifications, on one of
 * the first seeds, and its run shrinks. Mended in that one place, the same run is good. Besides
 * them, bugs of a set mutex for lemmas that those do not break.
 */
class SpecimenTest {

  private static final int SEEDS = 50;
  private static final int ROBOTS = 5;
  private static final int MOST_RUNS = 100;
  private static final int MOST_SCHEDULES = 500;
  private static final int CHANGES = 3;
  private static final int CHOICES = 8;
  private static final long END_NS = Duration.ofSeconds(60).toNanos();
  // As long as chaos: an outage may last until its end.
  private static final long BOUND_NS = Duration.ofSeconds(30).toNanos();
  private static final Trial CALM = new Trial(ROBOTS, List.of(), List.of(), END_NS);
  private static final Bounds BOUNDS =
      new Bounds(0, Time.NS_PER_MS, 100 * Time.NS_PER_MS, 80 * Time.NS_PER_MS, 2, 0, 1);

  private interface Maker {
    LogicThread make(GlobalVarHolder gvh, boolean isMended);
  }

  enum Specimen {
    TOKEN_MUTEX_WITH_STALE_OWNER_BROADCASTS("mutex.Exclusive", TokenMutex::new, MutexSpec::new),
    SET_MUTEX_WITH_LIST_INDEX_AND_DOUBLE_REPLIES(
        "mutex.Exclusive", setMutex(false, Bug.LIST_INDEX, Bug.DOUBLE_REPLIES), MutexSpec::new),
    SET_MUTEX_WITH_LIST_INDEX_ALONE(
        "mutex.Exclusive", setMutex(false, Bug.LIST_INDEX), MutexSpec::new),
    SET_MUTEX_WITH_DOUBLE_REPLIES_ALONE(
        "mutex.Exclusive", setMutex(false, Bug.DOUBLE_REPLIES), MutexSpec::new),
    SET_MUTEX_THAT_BREAKS_ITS_WORD("mutex.Promise", setMutex(true, Bug.LIST_INDEX), MutexSpec::new),
    SET_MUTEX_THAT_ASKS_NEIGHBOURS_ONLY(
        "mutex.Connected", setMutex(false, Bug.ASKS_NEIGHBOURS), MutexSpec::new),
    SET_MUTEX_THAT_LETS_STRANGERS_IN(
        "mutex.Complete", setMutex(false, Bug.LETS_STRANGERS_IN), MutexSpec::new),
    SET_MUTEX_THAT_ENTERS_ONE_ANSWER_EARLY(
        "Mutex_decls", setMutex(false, Bug.ENTERS_EARLY), MutexConformance::new),
    BARRIER_THAT_LOSES_EARLY_ARRIVALS(
        "barrier.NotHung", ForgetfulBarrier::new, () -> new BarrierSpec(BOUND_NS, 2 * END_NS)),
    GEOCAST_RECTANGLE_WITH_SWAPPED_EDGE("geocast.exclusion", CrookedGeocast::new, GeocastSpec::new),
    GEOCAST_THAT_IS_NO_RUN_OF_THE_THEORY(
        "Geocast_decls", CrookedGeocast::new, GeocastConformance::new);

    private final String lemma;
    private final Maker maker;
    private final Supplier<Monitor> spec;

    Specimen(String lemma, Maker maker, Supplier<Monitor> spec) {
      this.lemma = lemma;
      this.maker = maker;
      this.spec = spec;
    }

    private static Maker setMutex(boolean tellsGrants, Bug... bugs) {
      return (gvh, isMended) -> new SetMutex(gvh, isMended ? Set.of() : Set.of(bugs), tellsGrants);
    }

    Simulation simulation(
        long seed, Trial trial, Envelope chaos, boolean isMended, SimObserver... observers) {
      SimSettings settings =
          SimSettings.builder()
              .duration(Duration.ofNanos(trial.endNs()))
              .set(Setting.CHAOS, chaos)
              .build();
      Simulation.Builder simulation = Simulation.builder();
      List.of(observers).forEach(simulation::observer);
      return simulation
          .name(name())
          .seed(seed)
          .settings(settings)
          .faults(new FaultPlan(trial.faults()))
          .robots(trial.robots(), gvh -> maker.make(gvh, isMended))
          .monitor(() -> new Alone(spec.get()))
          .build();
    }

    /** The run of one seed, chaos written out. */
    Trial whole(long seed) {
      FaultPlan chaos = simulation(seed, CALM, Envelope.NETWORK, false).faults();
      return new Trial(ROBOTS, List.of(), chaos.faults(), END_NS);
    }

    RunOutcome run(long seed, Trial trial, boolean isMended) {
      return RunOutcome.of(simulation(seed, trial, Envelope.NONE, isMended).run());
    }

    boolean isCaught(RunOutcome outcome) {
      return outcome.verdict() == Verdict.VIOLATED && outcome.what().equals(lemma);
    }
  }

  /** A monitor without its companions, which might see first that a specimen is wrong. */
  private record Alone(Monitor monitor) implements Monitor {

    @Override
    public List<String> lemmas() {
      return monitor.lemmas();
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      monitor.observe(event, report);
    }

    @Override
    public void finish(long endNs, Report report) {
      monitor.finish(endNs, report);
    }
  }

  @ParameterizedTest
  @EnumSource
  void itIsCaughtAndItsRunShrinks(Specimen specimen, TestReporter reporter) {
    long seed = 1;
    while (seed <= SEEDS && !specimen.isCaught(specimen.run(seed, specimen.whole(seed), false))) {
      seed++;
    }
    assertThat(seed)
        .as("%s: caught on a seed of 1..%d", specimen, SEEDS)
        .isLessThanOrEqualTo(SEEDS);
    long caught = seed;
    Trial whole = specimen.whole(caught);
    Shrink.Result shrunk =
        new Shrink(
                trial -> specimen.run(caught, trial, false),
                MOST_RUNS,
                () -> false,
                (run, trial, outcome, isKept) -> {})
            .shrink(whole);
    Trial least = shrunk.trial();
    reporter.publishEntry(
        specimen.name(),
        "seed " + caught + ": " + whole + " -> " + least + ": " + shrunk.outcome().detail());
    assertThat(specimen.isCaught(shrunk.outcome())).as("%s", shrunk).isTrue();
    assertThat(least.endNs()).isLessThan(whole.endNs());
    assertThat(least.robots()).isLessThanOrEqualTo(whole.robots());
    assertThat(least.faults()).hasSizeLessThan(whole.faults().size());
    assertThat(specimen.run(caught, least, false)).isEqualTo(shrunk.outcome());
    assertThat(specimen.run(caught, whole, true).verdict()).isNotEqualTo(Verdict.VIOLATED);
    assertThat(specimen.run(caught, least, true).verdict()).isNotEqualTo(Verdict.VIOLATED);
  }

  /** On a seed whose run without faults does not show the bug, if there is one. */
  @ParameterizedTest
  @EnumSource(names = {"SET_MUTEX_WITH_DOUBLE_REPLIES_ALONE", "BARRIER_THAT_LOSES_EARLY_ARRIVALS"})
  void explorationFindsIt(Specimen specimen, TestReporter reporter) throws InterruptedException {
    long seed = 1;
    while (seed < SEEDS && specimen.isCaught(specimen.run(seed, CALM, false))) {
      seed++;
    }
    Explorer.Found found = null;
    for (Strategy strategy : Strategy.values()) {
      found = found == null ? explored(specimen, seed, strategy).found() : found;
    }
    assertThat(found).as("seed %d", seed).isNotNull();
    reporter.publishEntry(
        specimen.name(), "seed " + seed + ": schedule " + found.number() + ", " + found.schedule());
  }

  private static Explorer.Result explored(Specimen specimen, long seed, Strategy strategy)
      throws InterruptedException {
    int depth = strategy == Strategy.EXHAUSTIVE ? CHOICES : CHANGES;
    Explorer explorer =
        new Explorer(
            new Exploration(strategy, depth, seed, MOST_SCHEDULES, BOUNDS),
            (schedule, order) -> {
              Trial trial = new Trial(CALM.robots(), List.of(), schedule, END_NS);
              RunOutcome outcome =
                  RunOutcome.of(
                      specimen.simulation(seed, trial, Envelope.NONE, false, order).run());
              // Only the specimen's lemma counts, not an app that does not end.
              return specimen.isCaught(outcome) ? outcome : RunOutcome.good(outcome.figures());
            });
    return explorer.run();
  }
}
