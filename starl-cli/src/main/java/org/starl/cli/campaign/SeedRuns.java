package org.starl.cli.campaign;

import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.LongFunction;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.report.Chances;
import org.starl.cli.report.Coverage;
import org.starl.cli.report.DeliveryCounter;
import org.starl.cli.report.MessageCounts;
import org.starl.cli.report.RunFacts;
import org.starl.cli.report.SeedRow;
import org.starl.cli.request.RunRequest;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.check.Campaign;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.kernel.CarrierKind;

/** Runs the seeds of a campaign or a sweep, and hands on a row for each. */
final class SeedRuns {

  private final LongFunction<One> runs;
  private final CarrierKind carriers;
  private final boolean countsMessages;

  /** The kinds of faults of each run; also of one that an exception ended. */
  private final Map<Long, SortedSet<String>> kinds = new ConcurrentSkipListMap<>();

  /** The rows of the runs that ended without an exception. */
  private final Map<Long, SeedRow> rows = new ConcurrentSkipListMap<>();

  /**
   * One run.
   *
   * @param key of its point, as rows have it
   */
  record One(RunRequest request, String key, int point, long seed) {}

  /**
   * @param runs by number; may be called on several threads at once
   * @param countsMessages whether rows have the messages by channel, which only a report shows
   */
  SeedRuns(LongFunction<One> runs, CarrierKind carriers, boolean countsMessages) {
    this.runs = runs;
    this.carriers = carriers;
    this.countsMessages = countsMessages;
  }

  /**
   * Runs the campaign, whose seeds are the numbers of the runs.
   *
   * @param isLast called on the calling thread for each row in order; after the first true the
   *     campaign ends
   */
  void run(Campaign campaign, Campaign.Progress progress, Predicate<SeedRow> isLast)
      throws InterruptedException {
    campaign.run(this::run, progress, run -> isLast.test(row(run.seed(), run.outcome())));
  }

  /** The row of a run that ended with this outcome; to be called once. */
  private SeedRow row(long number, RunOutcome outcome) {
    SortedSet<String> faults = kinds.remove(number);
    SeedRow row = rows.remove(number);
    SortedSet<String> none = new TreeSet<>();
    return row != null ? row : row(number, outcome, faults == null ? none : faults, null, null);
  }

  private SeedRow row(
      long number,
      RunOutcome outcome,
      SortedSet<String> faults,
      @Nullable RunFacts facts,
      @Nullable Coverage coverage) {
    One one = runs.apply(number);
    return new SeedRow(one.key, one.point, one.seed, outcome, faults, facts, coverage);
  }

  /** Runs one; may be called on several threads at once. */
  private RunOutcome run(long number) {
    One one = runs.apply(number);
    Plan plan = plan(one.request, one.seed, carriers);
    SortedSet<String> faults = Chances.watch(plan.simulation());
    kinds.put(number, faults);
    MessageCounts messages = new MessageCounts();
    DeliveryCounter deliveries = new DeliveryCounter();
    plan.simulation().observer(deliveries);
    if (countsMessages) {
      plan.simulation().observer(messages);
    }
    SimResult result = correct(one.seed, () -> plan.simulation().build().run());
    RunFacts facts = RunFacts.of(result, plan.story(), messages);
    RunOutcome outcome = RunOutcome.of(result);
    SortedMap<String, Double> figures = new TreeMap<>(outcome.figures());
    figures.putAll(facts.measures().figures());
    outcome = outcome.withFigures(figures);
    Coverage coverage = Coverage.of(result.spec(), deliveries);
    rows.put(number, row(number, outcome, faults, facts, coverage));
    return outcome;
  }

  static Plan plan(RunRequest request, long seed, CarrierKind carriers) {
    Plan plan = correct(seed, () -> request.plan(seed));
    plan.simulation().carriers(carriers);
    return plan;
  }

  /** Bad input in the plan of this seed is a failed run: the plan of the first seed was correct. */
  private static <T> T correct(long seed, Supplier<T> work) {
    try {
      return work.get();
    } catch (BadInput e) {
      throw new IllegalStateException("seed " + seed + ": " + e.getMessage(), e);
    }
  }
}
