package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.sim.fault.ProbeRun.S;

import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.Determinism;
import org.starl.trace.TraceEvent;

class ChaosTest {

  private static Simulation.Builder probe(long seed, Envelope envelope) {
    return ProbeRun.simulation(seed)
        .settings(
            SimSettings.builder()
                .set("messageDelay", "10ms")
                .set("duration", "30s")
                .set("chaos", envelope.toString())
                .set("chaosFor", "6s")
                .build());
  }

  @Property(tries = 300)
  void aPlanEndsInTimeAndCanBeWritten(
      @ForAll Envelope envelope,
      @ForAll boolean isSealed,
      @ForAll long seed,
      @ForAll @IntRange(max = 100) int seconds) {
    FaultPlan plan = FaultPlan.chaos(envelope, isSealed, 5, 10 * S, seconds * S, new Rng(seed));
    assertThat(plan)
        .isEqualTo(FaultPlan.chaos(envelope, isSealed, 5, 10 * S, seconds * S, new Rng(seed)));
    assertThat(FaultPlan.parse(plan.toString())).isEqualTo(plan);
    assertThat(plan.isEmpty()).isEqualTo(envelope == Envelope.NONE || plan.faults().isEmpty());
    int deaths = 0;
    for (Fault fault : plan.faults()) {
      assertThat(fault.span().at().mostNs()).isLessThanOrEqualTo(seconds * S);
      if (fault.span().isFinite()) {
        assertThat(fault.span().untilNs()).isLessThanOrEqualTo(seconds * S);
      } else {
        assertThat(fault.effect().name()).isEqualTo("crash");
        deaths++;
      }
    }
    assertThat(deaths).isLessThanOrEqualTo(envelope == Envelope.MORTAL ? 2 : 0);
  }

  @Test
  void everyEnvelopeDrawsExactlyItsKindsOfFaults() {
    assertThat(kinds(Envelope.NONE)).isEmpty();
    Set<String> network = kinds(Envelope.NETWORK);
    assertThat(network)
        .containsExactlyInAnyOrder("loss", "burst", "delay", "duplicate", "reorder", "partition");
    Set<String> logical = kinds(Envelope.LOGICAL);
    assertThat(logical)
        .containsAll(network)
        .contains("crash", "forget", "disk", "compute", "drift", "skew");
    assertThat(logical).hasSize(network.size() + 6);
    assertThat(kinds(Envelope.MORTAL)).isEqualTo(logical);
    assertThat(kinds(Envelope.MOVING))
        .containsAll(network)
        .contains("crash", "forget", "disk", "drift", "noise")
        .hasSize(network.size() + 5);
    assertThat(kinds(Envelope.PHYSICAL))
        .containsAll(kinds(Envelope.SPATIAL))
        .contains("crash", "forget", "disk")
        .hasSize(network.size() + 9);
    assertThat(kinds(Envelope.UNLOCATED))
        .containsAll(kinds(Envelope.PHYSICAL))
        .contains("jump")
        .hasSize(network.size() + 10);
    assertThat(kinds(Envelope.SPATIAL))
        .containsAll(network)
        .contains("drift", "noise", "dropout", "skew", "slow", "stuck")
        .hasSize(network.size() + 6);
  }

  @Test
  void mostPlansHaveOutagesLongerThanTheLongestTimeout() {
    long withOutage = 0;
    long quiet = 0;
    Set<String> kinds = new TreeSet<>();
    for (long seed = 1; seed <= 200; seed++) {
      FaultPlan plan = FaultPlan.chaos(Envelope.LOGICAL, false, 5, 3 * S, 60 * S, new Rng(seed));
      FaultPlan without = FaultPlan.chaos(Envelope.LOGICAL, false, 5, 0, 60 * S, new Rng(seed));
      boolean isQuiet = !plan.faults().containsAll(without.faults());
      quiet += isQuiet ? 1 : 0;
      int before = isQuiet ? 0 : without.faults().size();
      for (Fault fault : plan.faults().subList(before, plan.faults().size())) {
        assertThat(!isQuiet || fault.effect().isCrash()).as("%s", fault).isTrue();
        long lastingNs = fault.span().untilNs() - fault.span().at().leastNs();
        assertThat(lastingNs).as("%s", fault).isBetween(3300 * ProbeRun.MS, 7800 * ProbeRun.MS);
        kinds.add(fault.effect().toString().replaceAll(".*name=(\\w+), arguments=", "$1"));
      }
      withOutage += plan.faults().size() > before ? 1 : 0;
    }
    assertThat(withOutage).isBetween(140L, 180L);
    assertThat(quiet).as("plans of outages only").isBetween(25L, 55L);
    assertThat(kinds)
        .anyMatch(kind -> kind.startsWith("crash"))
        .anyMatch(kind -> kind.contains("all>any"));
  }

  @Test
  void eachSeedHasItsOwnKindsOfFaultsAndItsOwnIntensity() {
    Set<Set<String>> subsets = new LinkedHashSet<>();
    Set<Integer> sizes = new TreeSet<>();
    for (long seed = 1; seed <= 200; seed++) {
      Set<String> kinds = new TreeSet<>();
      FaultPlan plan = FaultPlan.chaos(Envelope.LOGICAL, false, 5, 0, 60 * S, new Rng(seed));
      plan.faults().forEach(fault -> kinds.add(fault.effect().name()));
      subsets.add(kinds);
      sizes.add(plan.faults().size());
    }
    assertThat(subsets).hasSizeGreaterThan(100);
    assertThat(sizes).anyMatch(size -> size < 15).anyMatch(size -> size > 80);
  }

  @Test
  void anAttackerIsDrawnWhereDatagramsAreSealed() {
    Set<String> attacks = Set.of("forge", "replay", "flood");
    for (Envelope envelope : Envelope.values()) {
      Set<String> sealed = kinds(envelope, true);
      if (envelope == Envelope.NONE) {
        assertThat(sealed).isEmpty();
      } else {
        assertThat(sealed).as("%s", envelope).containsAll(attacks);
      }
      assertThat(kinds(envelope)).as("%s", envelope).doesNotContainAnyElementsOf(attacks);
    }
  }

  @Test
  void fixesAreWrongOnlyWhereNoRobotBelievesThem() {
    int wrong = 0;
    for (long seed = 1; seed <= 100; seed++) {
      FaultPlan plan = FaultPlan.chaos(Envelope.UNLOCATED, false, 4, 2 * S, 30 * S, new Rng(seed));
      long endNs = S;
      for (Fault fault : plan.faults()) {
        if (fault.effect().name().equals("jump")) {
          wrong++;
          assertThat(fault.span().at().leastNs()).isGreaterThanOrEqualTo(endNs);
          endNs = fault.span().untilNs();
          assertThat(endNs - fault.span().at().leastNs()).isLessThanOrEqualTo(10 * S);
          assertThat(plan.faults())
              .noneMatch(
                  other -> Set.of("crash", "forget", "dropout").contains(other.effect().name()));
        }
      }
    }
    assertThat(wrong).isGreaterThan(50);
  }

  private static Set<String> kinds(Envelope envelope) {
    return kinds(envelope, false);
  }

  private static Set<String> kinds(Envelope envelope, boolean isSealed) {
    Set<String> kinds = new TreeSet<>();
    for (long seed = 1; seed <= 100; seed++) {
      FaultPlan plan = FaultPlan.chaos(envelope, isSealed, 4, 10 * S, 30 * S, new Rng(seed));
      plan.faults().forEach(fault -> kinds.add(fault.effect().name()));
    }
    return kinds;
  }

  @Test
  void afterChaosAllRobotsReceiveEachOther() {
    for (Envelope envelope :
        new Envelope[] {Envelope.NETWORK, Envelope.LOGICAL, Envelope.SPATIAL}) {
      for (long seed = 1; seed <= 10; seed++) {
        ProbeRun run = ProbeRun.of(probe(seed, envelope));
        String what = envelope + ", seed " + seed + ": " + run.faults();
        assertThat(run.faults()).as(what).isNotEmpty();
        long healedNs = healedNs(run);
        assertThat(healedNs).as(what).isLessThanOrEqualTo(6 * S);
        assertThat(run.events)
            .as(what)
            .noneMatch(event -> event instanceof TraceEvent.Fault && event.timeNs() > healedNs);
        // Delayed datagrams arrive within 2 s; afterwards the run is as without faults.
        for (int from = 0; from < 3; from++) {
          for (int to = 0; to < 3; to++) {
            int sent = run.of(TraceEvent.Sent.class, from, 8 * S, 9 * S).size();
            boolean isOther = from != to && sent > 0;
            int heard = run.count(from, to, 8 * S, 9 * S + ProbeRun.MS * 20);
            assertThat(heard).as(what).isGreaterThanOrEqualTo(isOther ? sent : 0);
          }
        }
      }
    }
  }

  private static long healedNs(ProbeRun run) {
    return run.events.stream()
        .filter(e -> e instanceof TraceEvent.Fault f && f.name().equals(TraceEvent.Fault.HEALED))
        .mapToLong(TraceEvent::timeNs)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void permanentCrashesLeaveAMajorityAlive() {
    int dead = 0;
    for (long seed = 1; seed <= 20; seed++) {
      ProbeRun run = ProbeRun.of(probe(seed, Envelope.MORTAL));
      int down = 0;
      for (String line : run.faults()) {
        down += line.endsWith(" crash") ? 1 : line.contains(" restart ") ? -1 : 0;
      }
      assertThat(down).as("seed %d: %s", seed, run.faults()).isBetween(0, 1);
      dead += down;
    }
    assertThat(dead).isBetween(5, 20);
  }

  @Test
  void chaosDependsOnlyOnTheSeedOnBothCarriers() throws IOException {
    for (long seed = 1; seed <= 3; seed++) {
      long mine = seed;
      Determinism check = Determinism.verify(() -> probe(mine, Envelope.LOGICAL));
      assertThat(check.holds()).as("seed %d: %s", seed, check.difference()).isTrue();
    }
  }
}
