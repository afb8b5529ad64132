package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.Determinism;

class FaultDeterminismTest {

  private static final String[] EVERYTHING = {
    "crash(any,at=2s..4s,restart=1s..2s,lose=some)",
    "loss(0.2)",
    "burst(500ms,300ms,0.8)",
    "delay(exponential(40ms),at=1s..3s)",
    "duplicate(0.3)",
    "reorder(0.3,100ms)",
    "partition(any,at=4s..6s,for=1s)",
    "partition(any>any,at=4s..6s,for=1s)",
    "range(2m,at=5s)",
    "sight(at=7s)",
    "slow(any,0.7)",
    "noise(all,30mm,3deg)",
    "dropout(any,at=2s..8s,for=1s)",
    "jump(any,200mm,at=2s..8s,for=1s)",
    "compute(any,7ms)",
    "drift(any,200ppm)",
    "skew(any,-30ms,at=3s..5s)",
    "disk(all,30ms)",
    "ram(any,at=1s..6s,for=2s)",
    "block(any,at=1s..6s,for=2s)"
  };

  @Test
  void allFaultsTogetherDependOnlyOnTheSeedOnBothCarriers() throws IOException {
    for (int seed = 1; seed <= 3; seed++) {
      int mine = seed;
      Determinism check = Determinism.verify(() -> ProbeRun.simulation(mine, EVERYTHING));
      assertThat(check.holds()).as("seed %d: %s", seed, check.difference()).isTrue();
    }
  }

  @Test
  void differentSeedsDrawDifferentFaults() {
    assertThat(ProbeRun.of(ProbeRun.simulation(1, EVERYTHING)).faults())
        .isNotEqualTo(ProbeRun.of(ProbeRun.simulation(2, EVERYTHING)).faults());
  }
}
