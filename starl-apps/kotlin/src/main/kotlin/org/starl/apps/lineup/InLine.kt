package org.starl.apps.lineup

import org.starl.id.RobotId
import org.starl.apps.lineup.logic.LineupApp
import org.starl.spec.Bodies
import org.starl.spec.Monitor
import org.starl.trace.TraceEvent

/**
 * Specification of the app, by true bodies. `one_line`: all robots learn of the same line.
 * `in_line`: a robot that reports its arrival is at most [toleranceMm] away from the line.
 */
internal class InLine(private val toleranceMm: Double) : Monitor {

  private val bodies = Bodies()
  private var lineMm: Double? = null
  private val robots = sortedSetOf<RobotId>()

  override fun lemmas(): List<String> = listOf(ONE_LINE, IN_LINE)

  override fun observe(event: TraceEvent, report: Monitor.Report) {
    bodies.observe(event)
    val learntMm = LineupApp.lineMm(event)
    if (learntMm != null && event is TraceEvent.Action) {
      learns(event, learntMm, report)
    } else if (event is TraceEvent.Variable && event.isDone()) {
      arrives(event, report)
    }
  }

  private fun learns(event: TraceEvent.Action, learntMm: Double, report: Monitor.Report) {
    report.checked(ONE_LINE)
    val knownMm = lineMm ?: learntMm.also { lineMm = it }
    robots.add(event.robot())
    if (knownMm != learntMm) {
      val detail = "lines at $knownMm and at $learntMm mm"
      report.violated(ONE_LINE, event.timeNs(), robots.toList(), detail)
    }
  }

  private fun arrives(event: TraceEvent.Variable, report: Monitor.Report) {
    report.checked(IN_LINE)
    val xMm = bodies.poseAt(event.robot(), event.timeNs()).xMm()
    val goalMm = lineMm
    if (goalMm == null || Math.abs(xMm - goalMm) > toleranceMm) {
      report.violated(
        IN_LINE,
        event.timeNs(),
        listOf(event.robot()),
        "at $xMm mm, where the line is at $goalMm mm",
      )
    }
  }

  private fun TraceEvent.Variable.isDone() =
    source() == LineupApp.SOURCE &&
      name() == LineupApp.LOCATION &&
      value() == LineupApp.Location.DONE.name

  companion object {
    const val ONE_LINE = "one_line"
    const val IN_LINE = "in_line"
  }
}
