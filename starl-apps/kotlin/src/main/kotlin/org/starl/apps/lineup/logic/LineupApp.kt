package org.starl.apps.lineup.logic

import org.starl.GlobalVarHolder
import org.starl.gvh.GvhCell
import org.starl.LogicThread
import org.starl.geometry.ItemPosition
import org.starl.motion.MotionFlag
import org.starl.body.MotionParameters
import org.starl.primitives.agreement.Decision
import org.starl.primitives.agreement.SetAgreement
import org.starl.primitives.monitor.PrimitiveVocabulary
import org.starl.shape.RecordShape
import org.starl.shape.Shape
import org.starl.shape.Shapes
import org.starl.trace.TraceEvent
import org.starl.trace.Var
import org.starl.trace.Vocabulary

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

  /** Fact: this robot has learnt the x of the line. */
  data class Line(val xMm: Double)

  private val agreement = SetAgreement(gvh, INSTANCE, WHOLE_MM)
  private val location: GvhCell<Location> = gvh.variable(LOCATION, Location.PROPOSE)

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
            gvh.trace.action(LINE, Line(goal.at().xMm()))
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
    /** Where the program is. */
    @JvmField val LOCATION: Var<Location> = Var.of("location", Location::class.java)

    internal val LINE: RecordShape<Line> =
      Shapes.of(Line::class.java, Shapes.part("xMm", Shapes.REAL, Line::xMm), ::Line).named("line")

    /** What a reader of traces needs. */
    val VOCABULARY: Vocabulary =
      PrimitiveVocabulary.ALL.facts("app", LINE).variables("app", LOCATION)

    /** The x of the line in mm, if a robot learns it by this event. */
    fun lineMm(event: TraceEvent): Double? =
      ((event as? TraceEvent.Action)?.fact() as? Line)?.xMm

    /** The motion parameters for robots with this body. */
    fun motion(body: MotionParameters): MotionParameters =
      body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build()

    private const val GOAL_RADIUS_MM = 20.0
    private const val INSTANCE = "line"

    /** The value that robots propose: whole millimetres. */
    private val WHOLE_MM: Shape<Int> = Shapes.INT

    private const val PERIOD_MS = 100L
  }
}
