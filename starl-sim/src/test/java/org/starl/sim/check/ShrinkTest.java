package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.input.BadInput;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;
import org.starl.spec.SpecReport.Violation;

class ShrinkTest {

  private static final long S = 1_000_000_000;
  private static final Shrink.Progress SILENT = (run, trial, outcome, isKept) -> {};
  private static final RunOutcome GOOD = RunOutcome.good(new TreeMap<>());

  private static RunOutcome violated(String lemma, long atNs) {
    return RunOutcome.violated(
        new Violation(lemma, atNs, List.of(), "on purpose"), new TreeMap<>());
  }

  private static List<Fault> faults(int count) {
    List<Fault> faults = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      faults.add(FaultGrammar.parse("loss(0.5,at=" + i + "s,until=" + (i + 8) + "s)"));
    }
    return faults;
  }

  private static Trial trial(int robots, int faults) {
    return new Trial(robots, List.of("messageLoss", "speedError"), faults(faults), 1200 * S);
  }

  private static Shrink.Result shrink(Trial from, Function<Trial, RunOutcome> runner) {
    return new Shrink(runner, 10_000, () -> false, SILENT).shrink(from);
  }

  private static Function<Trial, RunOutcome> failsIf(Predicate<Trial> isBad) {
    return trial -> isBad.test(trial) ? violated("Lemma", 12_340_000_000L) : GOOD;
  }

  @Test
  void everythingUnneededIsRemoved() {
    Shrink.Result result =
        shrink(trial(12, 9), failsIf(t -> t.robots() >= 3 && t.endNs() > 12_340_000_000L));
    assertThat(result.trial()).isEqualTo(new Trial(3, List.of(), List.of(), 12_400_000_000L));
    assertThat(result.isSmallest()).isTrue();
    assertThat(result.trial()).hasToString("3 robots, 0 faults, 12400ms");
  }

  @Property(tries = 200)
  void exactlyTheNeededFaultsRemain(
      @ForAll @Size(max = 5) List<@IntRange(max = 19) Integer> needed,
      @ForAll @IntRange(min = 1, max = 20) int robots) {
    List<Fault> all = faults(20);
    List<String> beginnings =
        needed.stream().distinct().sorted().map(i -> begin(all.get(i))).toList();
    Shrink.Result result =
        shrink(
            trial(20, 20),
            failsIf(t ->
                t.robots() >= robots
                    && t.faults().stream()
                        .map(ShrinkTest::begin)
                        .toList()
                        .containsAll(beginnings)));
    assertThat(result.trial().faults()).extracting(ShrinkTest::begin).isEqualTo(beginnings);
    assertThat(result.trial().robots()).isEqualTo(robots);
    // Halved while that is 100 ms at least.
    assertThat(result.trial().faults())
        .allSatisfy(f -> assertThat(f.span().untilNs() - f.span().at().mostNs()).isLessThan(S / 4));
  }

  private static String begin(Fault fault) {
    return fault.span().at().toString();
  }

  @Test
  void aViolationOfAnotherLemmaIsADifferentFailure() {
    Shrink.Result result =
        shrink(trial(8, 4), t -> violated(t.robots() >= 5 ? "Lemma" : "Other", S));
    assertThat(result.trial().robots()).isEqualTo(5);
    assertThat(result.outcome().what()).isEqualTo("Lemma");
  }

  @Test
  void aTrialThatCannotRunIsRejected() {
    Shrink.Result result =
        shrink(
            trial(8, 4),
            t -> {
              if (t.robots() != 8) {
                throw new BadInput("robots: expected 8");
              }
              throw new IllegalStateException("on purpose");
            });
    assertThat(result.trial().robots()).isEqualTo(8);
    assertThat(result.trial().faults()).isEmpty();
    assertThat(result.outcome().verdict()).isEqualTo(Verdict.FAILED);
    assertThat(result.outcome().what()).isEqualTo("java.lang.IllegalStateException");
  }

  private static final RunOutcome UNFINISHED =
      new RunOutcome(Verdict.UNFINISHED, "", -1, "not finished", new TreeMap<>());

  /** A violation that is found at the end of the run: something has not been done. */
  private static RunOutcome owed(Trial trial) {
    RunOutcome found = violated("no_job_lost", trial.endNs());
    return new RunOutcome(
        found.verdict(),
        found.what(),
        found.atNs(),
        true,
        found.detail(),
        found.figures(),
        found.checks());
  }

  @Test
  void aGoalThatIsMissedWithoutFaultsKeepsItsRobotsAndItsTime() {
    Trial whole = new Trial(8, List.of(), List.of(), 1200 * S);
    assertThat(shrink(trial(8, 4), t -> UNFINISHED).trial()).isEqualTo(whole);
    assertThat(shrink(trial(8, 4), ShrinkTest::owed).trial()).isEqualTo(whole);
  }

  /** A fault prevents the goal, for which {@code robots} need {@code seconds}. */
  private static Function<Trial, RunOutcome> prevented(
      int robots, long seconds, Function<Trial, RunOutcome> failure) {
    String culprit = begin(faults(9).get(4));
    return t ->
        t.robots() < robots
                || t.endNs() < seconds * S
                || t.faults().stream().map(ShrinkTest::begin).anyMatch(culprit::equals)
            ? failure.apply(t)
            : GOOD;
  }

  @Test
  void theRobotsAndTheTimeThatTheGoalNeedsAreKeptIfAFaultIsToBlame() {
    for (Function<Trial, RunOutcome> failure :
        List.<Function<Trial, RunOutcome>>of(t -> UNFINISHED, ShrinkTest::owed)) {
      Shrink.Result result = shrink(trial(12, 9), prevented(3, 60, failure));
      assertThat(result.trial().robots()).isEqualTo(3);
      assertThat(result.trial().faults()).hasSize(1);
      assertThat(result.trial().endNs()).isGreaterThanOrEqualTo(60 * S);
      assertThat(result.cause()).containsExactly(faults(9).get(4));
    }
  }

  @Test
  void aFailureInTimeIsShortenedAlthoughItsGoodTwinDoesNotFinishThen() {
    Shrink.Result result =
        shrink(
            trial(12, 9),
            t ->
                t.faults().isEmpty()
                    ? t.endNs() < 300 * S ? UNFINISHED : GOOD
                    : violated("Lemma", 12 * S));
    assertThat(result.trial().endNs()).isEqualTo(12 * S + S / 10);
    assertThat(result.trial().robots()).isEqualTo(1);
  }

  @Property(tries = 100)
  void theCauseIsASmallestSetOfFaultsWithoutWhichTheRunIsGood(
      @ForAll @Size(min = 1, max = 4)
          List<@Size(min = 1, max = 3) List<@IntRange(max = 11) Integer>> conjunctions) {
    // It fails with all faults of any of the conjunctions.
    List<Fault> all = faults(12);
    List<List<Fault>> needed =
        conjunctions.stream()
            .map(numbers -> numbers.stream().distinct().map(all::get).toList())
            .toList();
    Predicate<List<Fault>> isBad = faults -> needed.stream().anyMatch(faults::containsAll);
    List<Fault> cause = shrink(trial(2, 12), failsIf(t -> isBad.test(t.faults()))).cause();
    List<Fault> left = new ArrayList<>(all);
    left.removeAll(cause);
    assertThat(cause).isNotEmpty();
    assertThat(isBad.test(left)).isFalse();
    for (Fault fault : cause) {
      List<Fault> more = new ArrayList<>(left);
      more.add(fault);
      assertThat(isBad.test(more)).as("without %s in %s", fault, cause).isTrue();
    }
  }

  @Test
  void noRunIsShrunkToNoRobots() {
    assertThat(shrink(trial(8, 0), t -> violated("Lemma", S)).trial().robots()).isEqualTo(1);
  }

  @Test
  void theEndIsSearchedIfTheTimeOfTheFailureIsUnknown() {
    RunOutcome failed = RunOutcome.failed(new IllegalStateException("on purpose"));
    Shrink.Result result = shrink(trial(1, 0), t -> t.endNs() > 77 * S ? failed : GOOD);
    assertThat(result.trial().endNs()).isBetween(77 * S, 81 * S);
  }

  @Test
  void aLemmaCheckedAtTheEndKeepsTheTimeItNeeds() {
    // Found at the end, as progress is; in a run of less than 60 s it is not owed.
    Shrink.Result result =
        shrink(trial(1, 0), t -> t.endNs() >= 60 * S ? violated("Lemma", 5 * S) : GOOD);
    assertThat(result.trial().endNs()).isBetween(60 * S, 63 * S);
  }

  @Test
  void shrinkingIsDeterministicAndRunsNoTrialTwice() {
    List<List<String>> told = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      List<String> lines = new ArrayList<>();
      List<Trial> trials = new ArrayList<>();
      Function<Trial, RunOutcome> runner =
          failsIf(t -> t.robots() * 2 + t.faults().size() > 13 && !t.settings().isEmpty());
      new Shrink(
              t -> {
                assertThat(trials).doesNotContain(t);
                trials.add(t);
                return runner.apply(t);
              },
              10_000,
              () -> false,
              (run, t, outcome, isKept) -> lines.add(run + " " + t + " " + isKept))
          .shrink(trial(9, 7));
      told.add(lines);
    }
    assertThat(told.get(0)).isEqualTo(told.get(1)).hasSizeGreaterThan(10);
    assertThat(told.get(0).get(0)).isEqualTo("1 9 robots, 2 settings, 7 faults, 1200s true");
  }

  @Test
  void shrinkingStopsAtTheLimitOfRunsAndReportsIt() {
    int[] runs = {0};
    Shrink.Result result =
        new Shrink(
                t -> {
                  runs[0]++;
                  return violated("Lemma", S);
                },
                4,
                () -> false,
                SILENT)
            .shrink(trial(9, 7));
    assertThat(runs[0]).isEqualTo(4);
    assertThat(result.runs()).isEqualTo(4);
    assertThat(result.isSmallest()).isFalse();
    assertThat(result.outcome().isGood()).isFalse();
  }

  @Test
  void noRunBeginsAfterAStopAlsoWhileTheCauseIsSearched() {
    int[] runs = {0};
    Shrink.Result result =
        new Shrink(
                t -> {
                  runs[0]++;
                  return t.faults().isEmpty() ? GOOD : violated("Lemma", S);
                },
                10_000,
                () -> runs[0] == 3,
                SILENT)
            .shrink(trial(9, 7));
    assertThat(runs[0]).isEqualTo(3);
    assertThat(result.isSmallest()).isFalse();
    assertThat(result.outcome().isGood()).isFalse();
  }

  @Test
  void aGoodRunIsRefused() {
    assertThatThrownBy(() -> shrink(trial(2, 1), t -> GOOD))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("2 robots, 2 settings, 1 fault, 1200s goes well");
  }

  @Test
  void aRunWithBadInputIsRefused() {
    RunOutcome wrong = RunOutcome.failed(new BadInput("no robot is called bot9"));
    assertThatThrownBy(() -> shrink(trial(2, 1), t -> wrong))
        .isInstanceOf(BadInput.class)
        .hasMessage("no robot is called bot9");
  }
}
