package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.starl.sim.Simulation;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;

/** A newcomer's app under loss. */
@Tag("long")
class PatrolTest {

  @StarlTest(seeds = 20, faults = "loss(0.2)")
  void everyRobotMakesItsRounds(Simulation.Builder simulation, RunChecks checks) {
    PatrolDemo.fill(simulation);
    checks.check(result ->
        assertThat(result.results().values()).hasSize(4).containsOnly(List.of("rounds: 3")));
  }
}
