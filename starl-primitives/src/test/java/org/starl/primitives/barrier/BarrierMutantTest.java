package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;

/** Barriers that are wrong in one place: the specification must see each, or it proves nothing. */
class BarrierMutantTest {

  private static final int SEEDS = 200;

  /** What is wrong, and which lemma must tell. */
  enum Mutant {
    ARRIVAL_OF_AN_OLD_GENERATION_COUNTS(BarrierSpec.NO_EARLY, OldGeneration::new),
    LOCAL_TIME_OUT(BarrierSpec.UNIFORM, LocalTimeOut::new),
    LOSES_EARLY_ARRIVALS(BarrierSpec.NOT_HUNG, LosesEarlyArrivals::new);

    private final String lemma;
    private final Member.Maker maker;

    Mutant(String lemma, Member.Maker maker) {
      this.lemma = lemma;
      this.maker = maker;
    }
  }

  /** Counts an arrival for the present generation, whichever it was meant for. */
  private static final class OldGeneration extends BarrierProtocol {
    OldGeneration(
        ProcessId me,
        SortedSet<ProcessId> first,
        BarrierSettings settings,
        Rng rng,
        SynodLink link,
        BarrierPort port,
        long nowNs) {
      super(me, first, settings, rng, link, port, nowNs);
    }

    @Override
    void count(ProcessId who, long itsGeneration) {
      super.count(who, generation());
    }
  }

  /** Tells at its deadline what it believes, without a decision. */
  private static final class LocalTimeOut extends BarrierProtocol {
    private final SortedSet<ProcessId> others;

    LocalTimeOut(
        ProcessId me,
        SortedSet<ProcessId> first,
        BarrierSettings settings,
        Rng rng,
        SynodLink link,
        BarrierPort port,
        long nowNs) {
      super(me, first, settings, rng, link, port, nowNs);
      others = new TreeSet<>(first);
      others.remove(me);
    }

    @Override
    void deadline() {
      next(new BarrierOutcome.Failed(generation(), others));
    }
  }

  /** One robot counts for all. */
  private static class Collector extends BarrierProtocol {
    private final ProcessId collector;

    Collector(
        ProcessId me,
        SortedSet<ProcessId> first,
        BarrierSettings settings,
        Rng rng,
        SynodLink link,
        BarrierPort port,
        long nowNs) {
      super(me, first, settings, rng, link, port, nowNs);
      collector = first.first();
    }

    @Override
    void check() {
      if (me().equals(collector)) {
        super.check();
      }
    }
  }

  /**
   * As in the original StarL: the collector forgets an arrival that reaches it before it has entered that
   * generation itself, and handles each message once.
   */
  private static final class LosesEarlyArrivals extends Collector {
    private final Set<List<Object>> handled = new LinkedHashSet<>();

    LosesEarlyArrivals(
        ProcessId me,
        SortedSet<ProcessId> first,
        BarrierSettings settings,
        Rng rng,
        SynodLink link,
        BarrierPort port,
        long nowNs) {
      super(me, first, settings, rng, link, port, nowNs);
    }

    @Override
    void count(ProcessId who, long itsGeneration) {
      if (handled.add(List.of(who, itsGeneration)) && isWaiting()) {
        super.count(who, itsGeneration);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void theSpecificationDetectsTheMutant(Mutant mutant) {
    assertSeen(mutant, mutant.lemma);
  }

  @ParameterizedTest
  @EnumSource(names = {"ARRIVAL_OF_AN_OLD_GENERATION_COUNTS", "LOCAL_TIME_OUT"})
  void theMutantDeviatesFromTheTheory(Mutant mutant) {
    assertSeen(mutant, BarrierAutomaton.BARRIER_DECLS);
  }

  private static void assertSeen(Mutant mutant, String lemma) {
    long seeds = 0;
    SpecReport report;
    do {
      seeds++;
      Gathering gathering = Gathering.drawn(seeds);
      gathering.maker = mutant.maker;
      gathering.live();
      report = gathering.finish();
    } while (report.violations(lemma) == 0 && seeds < SEEDS);
    assertThat(report.violations(lemma)).as("%s, seeds 1..%d", mutant, seeds).isPositive();
  }

  @Test
  void losingEarlyArrivalsHangsTheBarrier() {
    assertThat(meetsInGoodWeather(Collector::new).holds()).isTrue();
    SpecReport report = meetsInGoodWeather(LosesEarlyArrivals::new);
    assertThat(report.violations(BarrierSpec.NOT_HUNG)).as("%s", report).isPositive();
  }

  /** Without faults; only the collector is slow. */
  private static SpecReport meetsInGoodWeather(Member.Maker maker) {
    Gathering gathering = new Gathering(1, 3, BarrierSettings.DEFAULT);
    gathering.maker = maker;
    gathering.world.robots.forEach(Member::start);
    for (int i = 0; i < 200; i++) {
      for (Member member : gathering.world.robots) {
        boolean isSlow = member == gathering.world.robots.get(0) && i % 5 != 0;
        if (!member.protocol().isWaiting() && !isSlow) {
          member.arrive();
        }
      }
      gathering.world.runForMs(100);
    }
    return gathering.finish();
  }
}
