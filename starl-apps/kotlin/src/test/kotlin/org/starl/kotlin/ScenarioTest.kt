package org.starl.kotlin

import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.Test
import org.starl.apps.hello.logic.Hello
import org.starl.geometry.Pose
import org.starl.primitives.motion.MotionSpec
import org.starl.sim.Setting
import org.starl.sim.SimSettings
import org.starl.sim.Simulation
import org.starl.sim.fault.Envelope
import org.starl.sim.fault.FaultPlan
import org.starl.input.BadInput

/** The Kotlin scenario sets the builder's values. */
class ScenarioTest {

  @Test
  fun itIsTheSameRunAsTheBuilders() {
    val kotlin = simulation {
      seed = 7
      robots(4) { gvh -> Hello(gvh) }
      network {
        loss(0.1)
        delay("uniform(10ms,200ms)")
      }
      faults { +"slow(bot2,0.5,at=1s,for=2s)" }
      monitor { MotionSpec(SimSettings.defaults().motionParameters(0)) }
    }
    val java =
      Simulation.builder()
        .seed(7)
        .robots(4, ::Hello)
        .settings(
          SimSettings.builder()
            .set("messageLoss", "0.1")
            .set("messageDelay", "uniform(10ms,200ms)")
            .build()
        )
        .fault("slow(bot2,0.5,at=1s,for=2s)")
        .monitor { MotionSpec(SimSettings.defaults().motionParameters(0)) }
        .build()
    assertThat(kotlin.plan().header()).isEqualTo(java.plan().header())
    val result = kotlin.run()
    assertThat(result).hasToString(java.run().toString())
    assertThat(result.isFinished).isTrue()
    assertThat(result.spec().holds()).isTrue()
  }

  @Test
  fun everythingElseReachesTheBuilderToo() {
    val simulation = simulation {
      name("two")
      robot("alpha", Pose(0.0, 0.0, 0.0)) { gvh -> Hello(gvh) }
      robot("beta", Pose(0.0, 1000.0, 0.0)) { gvh -> Hello(gvh) }
      set("positionNoise", "2cm")
      set(Setting.IDEAL_MOTION, true)
      faults { chaos(Envelope.NETWORK) }
    }
    val plan = simulation.plan()
    assertThat(plan.header().robots().map { it.name() }).containsExactly("alpha", "beta")
    assertThat(plan.settings().get(Setting.POSITION_NOISE)).isEqualTo(20.0)
    assertThat(plan.settings().get(Setting.IDEAL_MOTION)).isTrue()
    assertThat(simulation.faults()).isNotEqualTo(FaultPlan.NONE)
    assertThat(simulation.run().isFinished).isTrue()
  }

  @Test
  fun whatTheBuilderRefusesIsRefused() {
    assertThatThrownBy { simulation { network { delay("banana(1)") } } }
      .isInstanceOf(BadInput::class.java)
      .hasMessageStartingWith("messageDelay='banana(1)': expected a delay")
    assertThatThrownBy { simulation { faults { +"crush(bot1)" } } }
      .isInstanceOf(BadInput::class.java)
      .hasMessageContaining("did you mean crash?")
  }
}
