package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.starl.sim.Simulation;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;

/** A newcomer's app under loss. */
@Tag("long")
class FormationTest {

  @StarlTest(seeds = 20, faults = "loss(0.2)")
  void allRobotsTakeOneFormation(Simulation.Builder simulation, RunChecks checks) {
    FormationDemo.fill(simulation);
    checks.check(result -> {
      assertThat(result.results()).hasSize(FormationDemo.ROBOTS);
      assertThat(Set.copyOf(result.results().values())).hasSize(1);
    });
  }
}
