package org.starl.apps.lineup.logic

import org.starl.GlobalVarHolder
import org.starl.gvh.GvhCell
import org.starl.LogicThread
import org.starl.comms.Codec
import org.starl.geometry.ItemPosition
import org.starl.motion.MotionFlag
import org.starl.body.MotionParameters
import org.starl.primitives.agreement.Decision
import org.starl.primitives.agreement.SetAgreement
import org.starl.trace.TraceEvent

/**
 * Robots line up: each proposes the x at which it stands, all agree on one of these, and each drives
 * along its own lane to that x. After a restart, a robot asks for the agreed value and goes on.
 */
class LineupApp(gvh: GlobalVarHolder) : LogicThread(gvh) {

  enum class Location {
    PROPOSE,
    AGREE,
    DRIVE,
    DONE,
  }

  private val agreement = SetAgreement(gvh, INSTANCE, WHOLE_MM)
  private val location: GvhCell<Location> = gvh.variable(SOURCE, LOCATION, Location.PROPOSE)

  init {
    gvh.plat.moat.setParameters(motion(gvh.plat.moat.parameters()))
  }

  override fun callStarL(): List<Any> {
    await(gvh.gps::hasFix)
    val laneMm = gvh.gps.pose().yMm()
    var goal = ItemPosition("line", gvh.gps.pose())
    while (location.get() != Location.DONE) {
      when (location.get()) {
        Location.PROPOSE -> {
          agreement.propose(Math.round(gvh.gps.pose().xMm()).toInt())
          location.set(Location.AGREE)
        }
        Location.AGREE -> {
          val decision = agreement.decided().get()
          if (decision is Decision.Decided) {
            goal = ItemPosition("line", decision.value().toDouble(), laneMm)
            gvh.trace.action(SOURCE, LINE, goal.at().xMm())
            gvh.plat.moat.doMove(goal)
            location.set(Location.DRIVE)
          } else if (agreement.failed().get()) {
            location.set(Location.PROPOSE)
          }
        }
        Location.DRIVE ->
          when (gvh.plat.moat.motionflag().get()) {
            MotionFlag.DONE -> location.set(Location.DONE)
            MotionFlag.FAIL -> gvh.plat.moat.doMove(goal)
            else -> {}
          }
        Location.DONE -> error("the loop has ended")
      }
      sleep(PERIOD_MS)
    }
    return listOf("in line at x = ${goal.at().xMm().toInt()} mm")
  }

  companion object {
    /** `source` of this app's trace events. */
    const val SOURCE = "app"

    /** Variable: the location. */
    const val LOCATION = "location"

    /** Action: this robot has learnt the x of the line, in mm. */
    const val LINE = "line"

    /** The x of the line in mm, if a robot learns it by this event. */
    fun lineMm(event: TraceEvent): Double? =
      if (event is TraceEvent.Action && event.source() == SOURCE && event.name() == LINE) {
        event.args().first().toDouble()
      } else {
        null
      }

    /** The motion parameters for robots with this body. */
    fun motion(body: MotionParameters): MotionParameters =
      body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build()

    private const val GOAL_RADIUS_MM = 20.0
    private const val INSTANCE = "line"

    /** The value that robots propose: whole millimetres. */
    private val WHOLE_MM: Codec<Int> = Codec.of({ mm, out -> out.i32(mm) }, { it.i32() })

    private const val PERIOD_MS = 100L
  }
}
