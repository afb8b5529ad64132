package org.starl.apps.hello;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.starl.apps.hello.logic.Hello;
import org.starl.body.MotionParameters;
import org.starl.motion.MotionFlag;
import org.starl.primitives.motion.MotionSpec;
import org.starl.sim.Simulation;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;

class HelloTest {

  @StarlTest(
      seeds = 50,
      faults = {"noise(all,10mm)", "slow(any,0.5,at=1s,for=2s)"})
  void everyRobotDrivesItsMetre(Simulation.Builder simulation, RunChecks checks) {
    simulation.robots(4, Hello::new).monitor(() -> new MotionSpec(MotionParameters.DEFAULT));
    checks.check(result ->
        assertThat(result.results().values()).hasSize(4).containsOnly(List.of(MotionFlag.DONE)));
  }
}
