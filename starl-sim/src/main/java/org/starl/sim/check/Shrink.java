package org.starl.sim.check;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.Span;
import org.starl.sim.fault.TimeRange;
import org.starl.time.Time;

/**
 * Reduces a bad run to a small one that fails in the same way (same lemma, same type of exception):
 * fewer robots, settings and faults, and less time. If the limit of runs suffices, the result is
 * minimal: no further step keeps the failure. Faults are removed in halves, quarters, and one by
 * one (Zeller, Hildebrandt, "Simplifying and isolating failure-inducing input", IEEE TSE 28(2),
 * 2002), then shortened.
 *
 * <p>Few robots in little time reach no goal, with or without faults: this is another failure. So, if
 * the run goes well without its faults, each smaller one must not fail in the same way without them.
 * If faults are not to blame, a run that has not reached its goal keeps its robots and its time.
 *
 * <p>The cause is a small set of faults, found in the same way, without which the run that was given
 * is good: none of them alone can be put back.
 *
 * <p>Deterministic: equal runs give equal results. The runs are executed one after another, on the
 * calling thread.
 */
public final class Shrink {

  private static final long END_STEP_NS = 100 * Time.NS_PER_MS;
  private static final long SHORTEST_FAULT_NS = 100 * Time.NS_PER_MS;

  /** The end of a run is searched to this relative precision. */
  private static final int END_PARTS = 50;

  private final Function<Trial, RunOutcome> runner;
  private final int mostRuns;
  private final BooleanSupplier isStopped;
  private final Progress progress;
  // Later passes repeat steps of earlier ones.
  private final Map<Trial, RunOutcome> known = new LinkedHashMap<>();
  private boolean areFaultsToBlame;
  private int runs;

  /** Called after each run of a smaller trial; not after those that only compare. */
  @FunctionalInterface
  public interface Progress {

    /**
     * @param run number of the run, from 1, which is the run to shrink
     * @param isKept whether it is the smallest so far that fails in the same way
     */
    void tried(int run, Trial trial, RunOutcome outcome, boolean isKept);
  }

  /**
   * The result of shrinking: the smallest trial.
   *
   * @param outcome of the trial
   * @param cause faults of the run to shrink, without which it is good; empty if none were
   *     found
   * @param runs number of runs executed
   * @param isSmallest false if the search ended before, at {@code mostRuns} or because it was stopped
   */
  public record Result(
      Trial trial, RunOutcome outcome, List<Fault> cause, int runs, boolean isSmallest) {}

  /** The smallest trial so far. */
  private record Best(Trial trial, RunOutcome outcome) {}

  /**
   * @param runner builds and executes a trial; equal trials must have equal outcomes. An exception
   *     is a failed run; {@code BadInput} differs from every failure to shrink, so that a trial
   *     that cannot run is rejected
   * @param mostRuns maximum number of runs
   * @param isStopped asked before each run; no run begins after true
   */
  public Shrink(
      Function<Trial, RunOutcome> runner,
      int mostRuns,
      BooleanSupplier isStopped,
      Progress progress) {
    this.runner = runner;
    this.mostRuns = mostRuns;
    this.isStopped = isStopped;
    this.progress = progress;
  }

  /**
   * Shrinks {@code from}.
   *
   * @throws IllegalArgumentException if {@code from} is a good run
   * @throws BadInput if {@code from} cannot run
   */
  public Result shrink(Trial from) {
    RunOutcome outcome = run(from);
    if (outcome.isGood()) {
      throw new IllegalArgumentException("nothing to shrink: " + from + " goes well");
    }
    if (outcome.isBadInput()) {
      throw new BadInput(outcome.detail());
    }
    known.put(from, outcome);
    runs = 1;
    progress.tried(runs, from, outcome, true);
    areFaultsToBlame = !from.faults().isEmpty() && !failsWithoutFaults(from, outcome);
    Best best = new Best(from, outcome);
    List<Fault> cause = areFaultsToBlame ? cause(from) : List.of();
    Best before;
    do {
      before = best;
      best = withFewerRobots(best);
      best = withFewerSettings(best);
      best = withFewerFaults(best);
      best = withShorterFaults(best);
      best = withEarlierEnd(best);
    } while (!best.equals(before) && !isOver());
    return new Result(best.trial(), best.outcome(), cause, runs, !isOver());
  }

  /** Puts faults back, as many as the run stays good with; the others are the cause. */
  private List<Fault> cause(Trial from) {
    List<Fault> removed = new ArrayList<>(from.faults());
    if (!isGoodWithout(from, removed)) {
      return List.of(); // it fails in another way then
    }
    for (int part = removed.size() / 2; part > 0; part /= 2) {
      int at = 0;
      while (at < removed.size()) {
        List<Fault> fewer = new ArrayList<>(removed);
        fewer.subList(at, Math.min(at + part, removed.size())).clear();
        if (!fewer.isEmpty() && isGoodWithout(from, fewer)) {
          removed = fewer;
        } else {
          at += part;
        }
      }
    }
    return removed;
  }

  private boolean isGoodWithout(Trial from, List<Fault> removed) {
    List<Fault> left = new ArrayList<>(from.faults());
    removed.forEach(left::remove);
    RunOutcome outcome = outcome(from.withFaults(left));
    return outcome != null && outcome.isGood();
  }

  private Best withFewerRobots(Best start) {
    if (isGoalMissed(start)) {
      return start;
    }
    Best best = start;
    boolean shrank = true;
    while (shrank) {
      int now = best.trial().robots();
      TreeSet<Integer> fewer = new TreeSet<>();
      for (int robots : new int[] {1, 2, 3, now / 4, now / 2, now * 3 / 4, now - 1}) {
        if (robots > 0 && robots < now) {
          fewer.add(robots);
        }
      }
      shrank = false;
      for (int robots : fewer) {
        Best next = tried(best, best.trial().withRobots(robots));
        if (!next.equals(best)) {
          best = next;
          shrank = true;
          break;
        }
      }
    }
    return best;
  }

  private Best withFewerSettings(Best start) {
    Best best = start;
    for (int i = best.trial().settings().size() - 1; i >= 0; i--) {
      best = tried(best, best.trial().withoutSetting(i));
    }
    return best;
  }

  private Best withFewerFaults(Best start) {
    Best best = start;
    for (int part = best.trial().faults().size(); part > 0; part /= 2) {
      int from = 0;
      while (from < best.trial().faults().size()) {
        int count = Math.min(part, best.trial().faults().size() - from);
        Best next = tried(best, best.trial().withoutFaults(from, count));
        from += next.equals(best) ? count : 0;
        best = next;
      }
    }
    return best;
  }

  private Best withShorterFaults(Best start) {
    Best best = start;
    for (int i = 0; i < best.trial().faults().size(); i++) {
      boolean shrank = true;
      while (shrank) {
        Fault fault = best.trial().faults().get(i);
        Fault shorter = halved(fault);
        Best next = shorter.equals(fault) ? best : tried(best, best.trial().withFault(i, shorter));
        shrank = !next.equals(best);
        best = next;
      }
    }
    return best;
  }

  /**
   * Half of the duration, in whole ms; unchanged if that is too short, or if the fault never ends.
   */
  private static Fault halved(Fault fault) {
    Span span = fault.span();
    TimeRange lasting = span.lasting();
    if (lasting != null) {
      long halfNs = wholeMs(lasting.mostNs() / 2);
      return halfNs < SHORTEST_FAULT_NS
          ? fault
          : new Fault(fault.effect(), new Span(span.at(), TimeRange.exactly(halfNs), Span.NEVER));
    }
    long halfNs = (span.untilNs() - span.at().mostNs()) / 2;
    return !span.isFinite() || halfNs < SHORTEST_FAULT_NS
        ? fault
        : new Fault(
            fault.effect(), new Span(span.at(), null, wholeMs(span.at().mostNs() + halfNs)));
  }

  private static long wholeMs(long ns) {
    return ns / Time.NS_PER_MS * Time.NS_PER_MS;
  }

  private Best withEarlierEnd(Best start) {
    if (isGoalMissed(start)) {
      return start;
    }
    Best best = start;
    long atNs = best.outcome().atNs();
    if (atNs >= 0) {
      long soonNs = (atNs / END_STEP_NS + 1) * END_STEP_NS;
      Best next =
          soonNs < best.trial().endNs() ? tried(best, best.trial().withEndNs(soonNs)) : best;
      if (!next.equals(best) || soonNs >= best.trial().endNs()) {
        return next;
      }
    }
    long tooSoonNs = Math.max(atNs, 0);
    long stepNs = Math.max(END_STEP_NS, best.trial().endNs() / END_PARTS);
    while (best.trial().endNs() - tooSoonNs > 2 * stepNs) {
      long middleNs = tooSoonNs + (best.trial().endNs() - tooSoonNs) / 2;
      middleNs = middleNs / END_STEP_NS * END_STEP_NS;
      Best next = tried(best, best.trial().withEndNs(middleNs));
      tooSoonNs = next.equals(best) ? middleNs : tooSoonNs;
      best = next;
    }
    return best;
  }

  /** Whether fewer robots and less time would fail in the same way, and tell nothing. */
  private boolean isGoalMissed(Best best) {
    return best.outcome().isOwed() && !areFaultsToBlame;
  }

  /** {@code trial} if it fails in the same way as {@code best}, otherwise {@code best}. */
  private Best tried(Best best, Trial trial) {
    boolean isNew = !known.containsKey(trial);
    RunOutcome outcome = outcome(trial);
    if (outcome == null) {
      return best;
    }
    int run = runs;
    boolean isKept =
        outcome.isLike(best.outcome()) && !(areFaultsToBlame && failsWithoutFaults(trial, outcome));
    if (isNew) {
      progress.tried(run, trial, outcome, isKept);
    }
    return isKept ? new Best(trial, outcome) : best;
  }

  private boolean failsWithoutFaults(Trial trial, RunOutcome failure) {
    RunOutcome outcome = outcome(trial.withFaults(List.of()));
    return outcome == null || outcome.isLike(failure);
  }

  private boolean isOver() {
    return runs >= mostRuns || isStopped.getAsBoolean();
  }

  /** Executes a trial, unless its outcome is known; null at the end of the search. */
  private @Nullable RunOutcome outcome(Trial trial) {
    RunOutcome before = known.get(trial);
    if (before != null || isOver()) {
      return before;
    }
    RunOutcome outcome = run(trial);
    known.put(trial, outcome);
    runs++;
    return outcome;
  }

  private RunOutcome run(Trial trial) {
    try {
      return runner.apply(trial);
    } catch (RuntimeException e) {
      return RunOutcome.failed(e);
    }
  }
}
