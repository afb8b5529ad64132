package org.starl.apps.lineup.view

import java.awt.Graphics2D
import java.awt.geom.Line2D
import org.starl.id.RobotId
import org.starl.apps.lineup.logic.LineupApp
import org.starl.sim.record.Layer
import org.starl.sim.record.Look
import org.starl.sim.record.Scene
import org.starl.trace.TraceEvent

/** Draws the line as soon as a robot knows it, and shows the location of each program. */
internal class LineLayer : Layer {

  private var lineMm: Double? = null

  override fun copy(): Layer = LineLayer().also { it.lineMm = lineMm }

  override fun observe(event: TraceEvent) {
    lineMm = LineupApp.lineMm(event) ?: lineMm
  }

  override fun paintFloor(floor: Graphics2D, scene: Scene, look: Look) {
    val xMm = lineMm ?: return
    val ysMm = scene.robots().mapNotNull { scene.pose(it).orElse(null)?.yMm() }
    if (ysMm.isNotEmpty()) {
      floor.color = look.theme().border()
      floor.stroke = look.line(LINE_MM)
      floor.draw(Line2D.Double(xMm, ysMm.min() - BEYOND_MM, xMm, ysMm.max() + BEYOND_MM))
    }
  }

  override fun describe(robot: RobotId, scene: Scene): String =
    scene.variable(robot, LineupApp.LOCATION)?.name ?: ""

  /** A picture shows most when all robots have driven. */
  override fun interest(scene: Scene): Double =
    scene.robots().sumOf { robot -> scene.driven(robot) }.toDouble()

  private companion object {
    const val LINE_MM = 20.0
    const val BEYOND_MM = 250.0
  }
}
