package org.starl.apps.lineup

import org.starl.apps.Demo
import org.starl.apps.Plan
import org.starl.apps.Request
import org.starl.apps.lineup.logic.LineupApp
import org.starl.apps.lineup.view.LineLayer
import org.starl.geometry.Pose
import org.starl.kotlin.ScenarioScope
import org.starl.kotlin.scenario
import org.starl.primitives.agreement.AgreementSpec
import org.starl.primitives.motion.MotionSpec
import org.starl.random.Rng
import org.starl.sim.SimSettings
import org.starl.sim.Simulation
import org.starl.sim.fault.Envelope
import org.starl.trace.Vocabulary
import org.starl.input.BadInput

/** `starl run lineup`: an app in Kotlin. */
class LineupDemo : Demo {

  override fun name() = "lineup"

  override fun summary() = "robots agree on a line and drive to it, each in its lane (in Kotlin)"

  override fun vocabulary(request: Request): Vocabulary = LineupApp.VOCABULARY

  override fun envelope(): Envelope = Envelope.MOVING

  override fun plan(request: Request, settings: SimSettings): Plan {
    val robots = request.robots().orElse(settings.robots())
    if (robots !in 1..MOST_ROBOTS) {
      throw BadInput("robots: $robots: expected 1 to $MOST_ROBOTS")
    }
    val simulation =
      Simulation.builder().settings(settings).scenario { lanes(robots, settings, request.seed()) }
    return Plan.of(simulation, LineLayer())
  }

  companion object {
    /** The largest group that the agreement is made for. */
    private const val MOST_ROBOTS = 64
    private const val LANE_MM = 600.0
    private const val LONGEST_MM = 3000.0

    /** Radius of a goal plus the largest error of a position fix. */
    private const val TOLERANCE_MM = 100.0

    /** Robots at drawn places of their own lanes, with the specifications. */
    internal fun ScenarioScope.lanes(robots: Int, settings: SimSettings, seed: Long) {
      val rng = Rng(seed).fork("lineup")
      repeat(robots) { i ->
        val start = Pose(rng.nextLong(0, LONGEST_MM.toLong()).toDouble(), LANE_MM * (i + 1), 0.0)
        robot("${settings.robotName()}$i", start) { gvh -> LineupApp(gvh) }
      }
      monitor { InLine(TOLERANCE_MM) }
      monitor { AgreementSpec() }
      monitor { MotionSpec(LineupApp.motion(settings.motionParameters(0))) }
    }
  }
}
