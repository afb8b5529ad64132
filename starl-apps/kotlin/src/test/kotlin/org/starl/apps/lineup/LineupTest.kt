package org.starl.apps.lineup

import org.assertj.core.api.Assertions.assertThat
import org.junit.jupiter.api.Test
import org.starl.id.RobotId
import org.starl.apps.lineup.LineupDemo.Companion.lanes
import org.starl.apps.lineup.logic.LineupApp
import org.starl.apps.lineup.logic.LineupApp.Location
import org.starl.geometry.Pose
import org.starl.kotlin.scenario
import org.starl.sim.Simulation
import org.starl.sim.fault.Envelope
import org.starl.sim.junit.RunChecks
import org.starl.sim.junit.StarlTest
import org.starl.spec.Monitor
import org.starl.trace.Instance
import org.starl.trace.TraceEvent

/** Robots line up on one line, under any faults of the network and with restarts. */
class LineupTest {

  private val reported = mutableListOf<String>()

  private val report =
    object : Monitor.Report {
      override fun checked(lemma: String) {}

      override fun violated(lemma: String, timeNs: Long, robots: List<RobotId>, detail: String) {
        reported.add("$lemma $robots $detail")
      }
    }

  @StarlTest(seeds = 20, faults = ["loss(0.2)", "crash(any,at=1s..9s,restart=2s)"])
  fun everyRobotEndsOnTheSameLine(
    simulation: Simulation.Builder,
    checks: RunChecks,
    seed: Long,
  ) {
    simulation.scenario { lanes(5, simulation.settings(), seed) }
    checks.check { result ->
      assertThat(result.results()).hasSize(5)
      assertThat(result.results().values.toSet()).hasSize(1)
    }
  }

  @StarlTest(seeds = 10, chaos = Envelope.MOVING)
  fun chaosIsBorne(simulation: Simulation.Builder, seed: Long) {
    simulation.scenario { lanes(4, simulation.settings(), seed) }
  }

  @Test
  fun twoLinesAreTold() {
    val monitor = InLine(toleranceMm = 150.0)
    monitor.observe(line(A, 1000.0), report)
    assertThat(reported).isEmpty()
    monitor.observe(line(B, 1001.0), report)
    assertThat(reported).containsExactly("${InLine.ONE_LINE} [bot0, bot1] lines at 1000.0 and at 1001.0 mm")
  }

  @Test
  fun whoIsNotInLineAndSaysSoIsTold() {
    val monitor = InLine(toleranceMm = 150.0)
    monitor.observe(TraceEvent.Joined(0, A, Pose(1200.0, 600.0, 0.0), 165.0), report)
    monitor.observe(line(A, 1000.0), report)
    monitor.observe(at(1, Location.DRIVE), report)
    assertThat(reported).isEmpty()
    monitor.observe(at(2, Location.DONE), report)
    assertThat(reported)
      .containsExactly("${InLine.IN_LINE} [bot0] at 1200.0 mm, where the line is at 1000.0 mm")
  }

  private fun line(robot: RobotId, xMm: Double) =
    TraceEvent.Action.of(0, robot, Instance.APP, LineupApp.LINE, LineupApp.Line(xMm))

  private fun at(timeNs: Long, location: Location) =
    TraceEvent.Variable(timeNs, A, Instance.APP, LineupApp.LOCATION, location)

  private companion object {
    val A = RobotId("bot0")
    val B = RobotId("bot1")
  }
}
