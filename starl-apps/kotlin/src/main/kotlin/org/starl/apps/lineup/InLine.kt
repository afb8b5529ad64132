package org.starl.apps.lineup

import org.starl.id.RobotId
import org.starl.apps.lineup.logic.LineupApp
import org.starl.primitives.monitor.AppMonitor

/**
 * Specification of the app, by true bodies. `one_line`: all robots learn of the same line.
 * `in_line`: a robot that reports its arrival is at most [toleranceMm] away from the line.
 */
internal class InLine(private val toleranceMm: Double) : AppMonitor() {

  private var lineMm: Double? = null
  private val robots = sortedSetOf<RobotId>()

  init {
    lemma(ONE_LINE, "All robots learn of the same line.")
    lemma(IN_LINE, "A robot that reports its arrival is at the line.")
    on(LineupApp.Line::class.java) { robot, line -> learns(robot, line.xMm) }
    on(LineupApp.LOCATION) { robot, location ->
      if (location == LineupApp.Location.DONE) {
        arrives(robot)
      }
    }
  }

  private fun learns(robot: RobotId, learntMm: Double) {
    val knownMm = lineMm ?: learntMm.also { lineMm = it }
    robots.add(robot)
    check(ONE_LINE, knownMm == learntMm, robots, "lines at $knownMm and at $learntMm mm")
  }

  private fun arrives(robot: RobotId) {
    val xMm = bodies().poseAt(robot, nowNs()).xMm()
    val goalMm = lineMm
    val isThere = goalMm != null && Math.abs(xMm - goalMm) <= toleranceMm
    check(IN_LINE, isThere, listOf(robot), "at $xMm mm, where the line is at $goalMm mm")
  }

  companion object {
    const val ONE_LINE = "lineup.one_line"
    const val IN_LINE = "lineup.in_line"
  }
}
