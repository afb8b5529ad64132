package org.starl.kotlin

import org.starl.GlobalVarHolder
import org.starl.LogicThread
import org.starl.SuspendedThread
import org.starl.primitives.mutex.M_Mutex
import org.starl.primitives.mutex.MutexFailure

/** Visits the dock; a robot that waits blocks. */
class Visitor(gvh: GlobalVarHolder, private val visits: Int) : LogicThread(gvh) {

  private val mutex = M_Mutex(gvh, "dock", gvh.id.participants())

  override fun callStarL(): List<Any> {
    await(gvh.gps::hasFix)
    var made = 0
    while (made < visits) {
      if (mutex.acquire(listOf("dock"), 60_000) == MutexFailure.NONE) {
        sleep(500)
        mutex.release("dock")
        made++
      }
    }
    return listOf("visits: $made")
  }
}

/** The same; a robot that waits suspends. */
class SuspendedVisitor(gvh: GlobalVarHolder, private val visits: Int) : SuspendedThread(gvh) {

  private val mutex = M_Mutex(gvh, "dock", gvh.id.participants())

  override suspend fun callStarL(): List<Any> {
    await(gvh.gps::hasFix)
    var made = 0
    while (made < visits) {
      if (await(mutex.acquiring(listOf("dock"), 60_000)) == MutexFailure.NONE) {
        sleep(500)
        mutex.release("dock")
        made++
      }
    }
    return listOf("visits: $made")
  }
}
