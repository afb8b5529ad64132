package org.starl.apps.lineup

import org.starl.id.RobotId
import org.starl.apps.lineup.logic.LineupApp
import org.starl.sim.record.Layer
import org.starl.sim.record.Scene

/** Tells where in its program each robot is; most is to be seen when all have driven. */
internal class TrailLayer : Layer {

  override fun copy(): Layer = this

  override fun describe(robot: RobotId, scene: Scene): String =
    scene.variable(robot, LineupApp.SOURCE, LineupApp.LOCATION)

  override fun interest(scene: Scene): Double =
    scene.robots().sumOf { robot -> scene.trail(robot).size }.toDouble()
}
