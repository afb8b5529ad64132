package org.starl.kotlin.bench

import org.starl.GlobalVarHolder
import org.starl.RobotApp
import org.starl.SuspendedThread
import org.starl.bench.KernelWorkload
import org.starl.id.RobotId
import org.starl.platform.Waits
import org.starl.random.Rng

/** The robots of `starl bench b1 --style suspended`. */
class SuspendedRobots : KernelWorkload.Suspending {

  override fun robot(
    gvh: GlobalVarHolder,
    ids: List<RobotId>,
    me: Int,
    rng: Rng,
    phaseNs: Long,
  ): RobotApp = SuspendedRobot(gvh, ids, me, rng, phaseNs)

  private class SuspendedRobot(
    gvh: GlobalVarHolder,
    private val ids: List<RobotId>,
    private val me: Int,
    private val rng: Rng,
    private val phaseNs: Long,
  ) : SuspendedThread(gvh) {
    private var received = 0
    private val endpoint =
      gvh.comms.open(KernelWorkload.CHANNEL) { _, message -> received += message }

    override suspend fun callStarL(): List<Any> {
      val startNs = gvh.plat.clock.nowNs() + phaseNs
      await(Waits<Boolean> { it.until(null, startNs) { held -> it.end(held) } })
      repeat(KernelWorkload.ROUNDS) {
        sleep(KernelWorkload.PERIOD_MS)
        KernelWorkload.sendToRandomRobot(endpoint, ids, me, rng)
      }
      return listOf(received)
    }
  }
}
