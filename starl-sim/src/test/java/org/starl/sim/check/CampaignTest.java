package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.CountDownLatch;
import java.util.stream.LongStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.RunOutcome.Verdict;
import org.starl.spec.SpecReport.Violation;

class CampaignTest {

  private static final Campaign.Progress SILENT = (finished, planned, bad) -> {};

  private static RunOutcome outcome(long seed, long badEvery) {
    TreeMap<String, Double> figures = new TreeMap<>(Map.of("seed", (double) seed));
    return seed % badEvery == 0
        ? RunOutcome.violated(new Violation("even", seed, List.of(), "seed " + seed), figures)
        : RunOutcome.good(figures);
  }

  @Property(tries = 50)
  void theResultIsTheSameOnAnyNumberOfThreads(
      @ForAll @IntRange(min = 1, max = 8) int workers,
      @ForAll @LongRange(min = -50, max = 50) long first,
      @ForAll @IntRange(max = 200) int more,
      @ForAll boolean stopAtBad)
      throws InterruptedException {
    long last = first + more;
    CampaignResult alone =
        new Campaign(first, last, 1, stopAtBad).run(seed -> outcome(seed, 17), SILENT);
    CampaignResult many =
        new Campaign(first, last, workers, stopAtBad).run(seed -> outcome(seed, 17), SILENT);
    assertThat(many).isEqualTo(alone);
    assertThat(many.runs()).isSortedAccordingTo((a, b) -> Long.compare(a.seed(), b.seed()));
  }

  @Test
  void aLemmaThatNoRunOfManyHasCheckedFailsTheCampaign() throws InterruptedException {
    CampaignResult many = new Campaign(1, 100).run(seed -> checked(seed, 0), SILENT);
    assertThat(many.neverChecked()).containsExactly("quiet");
    assertThat(many.leavesUnchecked()).isTrue();
    CampaignResult few = new Campaign(1, 99).run(seed -> checked(seed, 0), SILENT);
    assertThat(few.neverChecked()).containsExactly("quiet");
    assertThat(few.leavesUnchecked()).isFalse();
    CampaignResult one = new Campaign(1, 100).run(seed -> checked(seed, seed / 100), SILENT);
    assertThat(one.leavesUnchecked()).isFalse();
  }

  private static RunOutcome checked(long seed, long quiet) {
    TreeMap<String, Long> checks = new TreeMap<>(Map.of("loud", seed, "quiet", quiet));
    return new RunOutcome(Verdict.GOOD, "", -1, false, "", new TreeMap<>(), checks);
  }

  @Test
  void aCampaignContinuesAfterABadRunUnlessConfiguredToStop() throws InterruptedException {
    CampaignResult all = new Campaign(1, 100, 3, false).run(seed -> outcome(seed, 10), SILENT);
    assertThat(all.runs()).hasSize(100);
    assertThat(all.count(Verdict.VIOLATED)).isEqualTo(10);
    assertThat(all.count(Verdict.GOOD)).isEqualTo(90);
    CampaignResult some = new Campaign(1, 100, 3, true).run(seed -> outcome(seed, 10), SILENT);
    assertThat(some.runs()).hasSize(10);
    assertThat(some.firstBad())
        .isEqualTo(new CampaignResult.Run(10, outcome(10, 10)))
        .isEqualTo(all.firstBad());
  }

  @Test
  void theLowestBadSeedIsReportedEvenIfAnotherIsFoundEarlier() throws InterruptedException {
    CountDownLatch laterIsBad = new CountDownLatch(1);
    CampaignResult result =
        new Campaign(1, 1_000, 2, true)
            .run(
                seed -> {
                  if (seed == 1) {
                    awaitQuietly(laterIsBad);
                    return outcome(1, 1);
                  }
                  laterIsBad.countDown();
                  return outcome(seed, 1);
                },
                SILENT);
    assertThat(result.runs()).extracting(CampaignResult.Run::seed).containsExactly(1L);
  }

  @Test
  void eachThreadExecutesOneRunAtATime() throws InterruptedException {
    Set<String> busy = new ConcurrentSkipListSet<>();
    List<String> overlaps = Collections.synchronizedList(new ArrayList<>());
    new Campaign(1, 200, 4, false)
        .run(
            seed -> {
              String thread = Thread.currentThread().getName();
              if (!busy.add(thread)) {
                overlaps.add(thread);
              }
              busy.remove(thread);
              return outcome(seed, 7);
            },
            SILENT);
    assertThat(overlaps).isEmpty();
  }

  @Test
  void anExceptionIsAFailedRun() throws InterruptedException {
    CampaignResult result =
        new Campaign(1, 3, 2, false)
            .run(
                seed -> {
                  if (seed == 2) {
                    throw new IllegalStateException("robot bot0 broke\nat length");
                  }
                  return outcome(seed, 10);
                },
                SILENT);
    CampaignResult.Run bad = Objects.requireNonNull(result.firstBad());
    assertThat(bad.seed()).isEqualTo(2);
    assertThat(bad.outcome().verdict()).isEqualTo(Verdict.FAILED);
    assertThat(bad.outcome().detail()).isEqualTo("robot bot0 broke");
  }

  @Test
  void theRunThatDecidesEndsTheCampaignOnAnyNumberOfThreads() throws InterruptedException {
    for (int workers : new int[] {1, 2, 7}) {
      List<Long> seen = new ArrayList<>();
      CampaignResult result =
          new Campaign(5, 500, workers, false)
              .run(
                  seed -> outcome(seed, 3),
                  SILENT,
                  run -> {
                    seen.add(run.seed());
                    return run.seed() >= 40;
                  });
      assertThat(result.runs()).hasSize(36);
      assertThat(seen).isEqualTo(LongStream.rangeClosed(5, 40).boxed().toList());
    }
  }

  @Test
  void aThrownErrorEndsTheCampaign() {
    StackOverflowError error = new StackOverflowError("too deep");
    assertThatThrownBy(() ->
            new Campaign(1, 1_000, 2, false)
                .run(
                    seed -> {
                      throw error;
                    },
                    SILENT))
        .isSameAs(error);
  }

  @Test
  void aRunThatDoesNotEndIsToldWhileItRuns() throws InterruptedException {
    CountDownLatch told = new CountDownLatch(1);
    SortedSet<Long> seen = new TreeSet<>();
    Campaign.Progress progress =
        new Campaign.Progress() {
          @Override
          public void advanced(long finished, long planned, long bad) {}

          @Override
          public void running(SortedSet<Long> seeds) {
            seen.addAll(seeds);
            if (seeds.contains(3L)) {
              told.countDown();
            }
          }
        };
    CampaignResult result =
        new Campaign(1, 4, 2, false)
            .run(
                seed -> {
                  if (seed == 3) {
                    awaitQuietly(told);
                  }
                  return RunOutcome.good(new TreeMap<>());
                },
                progress);
    assertThat(result.runs()).hasSize(4);
    assertThat(seen).contains(3L).isSubsetOf(1L, 2L, 3L, 4L);
  }

  @Test
  void progressIsReportedOnTheCallingThreadAfterEachRun() throws InterruptedException {
    List<Long> finished = new ArrayList<>();
    List<Thread> threads = new ArrayList<>();
    List<Long> bads = new ArrayList<>();
    new Campaign(1, 20, 3, false)
        .run(
            seed -> outcome(seed, 10),
            (done, planned, bad) -> {
              assertThat(planned).isEqualTo(20);
              finished.add(done);
              bads.add(bad);
              threads.add(Thread.currentThread());
            });
    assertThat(finished).hasSize(20).isSorted().last().isEqualTo(20L);
    assertThat(bads).isSorted().last().isEqualTo(2L);
    assertThat(threads).containsOnly(Thread.currentThread());
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "1, 1", "50, 50", "50.1, 51", "95, 95", "99.5, 100", "100, 100"})
  void percentilesAreSamples(double percent, double expected) throws InterruptedException {
    CampaignResult result = new Campaign(1, 100, 2, false).run(seed -> outcome(seed, 3), SILENT);
    assertThat(result.figures()).containsExactly("seed");
    assertThat(result.samples("seed")).isEqualTo(100);
    assertThat(result.percentile("seed", percent)).isEqualTo(expected);
  }

  @Test
  void anEmptySampleHasNoPercentile() {
    CampaignResult nothing = new CampaignResult(List.of());
    assertThatThrownBy(() -> nothing.percentile("x", 50)).hasMessageContaining("0 samples of 'x'");
  }

  @Test
  void seedsAreARange() throws InterruptedException {
    assertThatThrownBy(() -> new Campaign(2, 1)).hasMessageContaining("2..1");
    assertThatThrownBy(() -> new Campaign(Long.MIN_VALUE, Long.MAX_VALUE))
        .isInstanceOf(IllegalArgumentException.class);
    long max = Long.MAX_VALUE;
    assertThat(new Campaign(max - 1, max, 2, true).run(s -> outcome(s, 2), SILENT).runs())
        .extracting(CampaignResult.Run::seed)
        .containsExactly(max - 1);
  }

  @Test
  void aSimulationReportsItsResult() throws InterruptedException {
    CampaignResult result =
        new Campaign(1, 4, 2, false)
            .run(seed -> RunOutcome.of(sleepers(seed).build().run()), SILENT);
    assertThat(result.count(Verdict.GOOD)).isEqualTo(2);
    assertThat(result.count(Verdict.UNFINISHED)).isEqualTo(2);
    CampaignResult.Run bad = Objects.requireNonNull(result.firstBad());
    assertThat(bad.outcome().detail()).startsWith("not finished: [bot0, bot1]; ");
    assertThat(result.percentile("end_s", 100)).isEqualTo(5);
  }

  /** With an odd seed they oversleep the end of the run. */
  private static Simulation.Builder sleepers(long seed) {
    return Simulation.builder()
        .seed(seed)
        .settings(SimSettings.builder().set("duration", "5s").build())
        .robots(2, gvh -> new Sleeper(gvh, seed % 2 == 0 ? 1_000 : 10_000));
  }

  private static final class Sleeper extends LogicThread {
    private final long ms;

    Sleeper(GlobalVarHolder gvh, long ms) {
      super(gvh);
      this.ms = ms;
    }

    @Override
    public List<Object> callStarL() {
      sleep(ms);
      return returnResults();
    }
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
