package org.starl

import java.util.function.BooleanSupplier
import java.util.function.Consumer
import kotlin.coroutines.Continuation
import kotlin.coroutines.CoroutineContext
import kotlin.coroutines.EmptyCoroutineContext
import kotlin.coroutines.intrinsics.COROUTINE_SUSPENDED
import kotlin.coroutines.intrinsics.suspendCoroutineUninterceptedOrReturn
import kotlin.coroutines.jvm.internal.CoroutineStackFrame
import kotlin.coroutines.resume
import kotlin.coroutines.resumeWithException
import org.starl.platform.StrandClosed
import org.starl.platform.SuspendedApp
import org.starl.platform.Waits

/**
 * A robot's app whose [callStarL] suspends where that of a [LogicThread] blocks: the same strand, the
 * same order of events, the same trace. While it waits it needs an object of some hundred bytes and no
 * thread, so it is for many robots.
 *
 * Wait only with [sleep] and [await]. A blocking call, such as `mutex.acquire(..)`, fails; its
 * suspending form is `await(mutex.acquiring(..))`. Coroutines of other libraries fail too: nothing but
 * the strand resumes an app.
 */
public abstract class SuspendedThread(gvh: GlobalVarHolder) : RobotApp(gvh), SuspendedApp {

  private var isWaiting = false
  private var isOver = false
  private lateinit var ending: Ending

  /**
   * Runs the app. After it returns, the robot still answers messages until it leaves.
   *
   * @return the app's results
   */
  public abstract suspend fun callStarL(): List<Any>

  final override fun launch(whenFinished: Consumer<List<Any>>) {
    ending = Ending(this, whenFinished)
    strand.start(this)
  }

  /**
   * Waits [ms] milliseconds, as [LogicThread.sleep]: above 0 in a loop.
   */
  protected suspend fun sleep(ms: Long) {
    suspendUntil(null, inMs(ms))
  }

  /** Waits until [condition] holds, as [LogicThread.await]. */
  protected suspend fun await(condition: BooleanSupplier) {
    suspendUntil(condition, Long.MAX_VALUE)
  }

  /** Waits until [condition] holds or [timeoutMs] have passed; returns whether it held. */
  protected suspend fun await(condition: BooleanSupplier, timeoutMs: Long): Boolean =
    suspendUntil(condition, inMs(timeoutMs))

  /** Waits until [condition] holds, which [name] describes: it is shown if the run ends meanwhile. */
  protected suspend fun await(name: String, condition: BooleanSupplier) {
    awaited = name
    await(condition)
    awaited = ""
  }

  /** Waits at most [timeoutMs], with a name as above. */
  protected suspend fun await(name: String, condition: BooleanSupplier, timeoutMs: Long): Boolean {
    awaited = name
    val held = await(condition, timeoutMs)
    awaited = ""
    return held
  }

  /** Runs a [call] that waits, such as `mutex.acquiring(..)`, and returns what it returns. */
  protected suspend fun <T : Any> await(call: Waits<T>): T {
    var held = false
    while (!call.goOn(held)) {
      held = suspendUntil(call.condition(), call.untilNs())
    }
    return call.result()
  }

  private suspend fun suspendUntil(condition: BooleanSupplier?, untilNs: Long): Boolean =
    suspendCoroutineUninterceptedOrReturn { here ->
      if (strand.suspendUntil(condition, untilNs, here)) {
        true
      } else {
        isWaiting = true
        COROUTINE_SUSPENDED
      }
    }

  /** For the strand. */
  @Suppress("UNCHECKED_CAST")
  final override fun resume(continuation: Any?, held: Boolean, closed: StrandClosed?): Boolean {
    isWaiting = false
    val here = continuation as Continuation<Boolean>?
    when {
      here == null -> start()
      closed == null -> here.resume(held)
      else -> here.resumeWithException(closed)
    }
    check(isWaiting || isOver) {
      "callStarL suspends outside sleep and await: expected these alone"
    }
    return isOver
  }

  // As startCoroutineUninterceptedOrReturn, without its object for a dispatcher.
  @Suppress("UNCHECKED_CAST")
  private fun start() {
    val body = this::callStarL as Function1<Continuation<List<Any>>, Any?>
    val returned = body(ending)
    if (returned !== COROUTINE_SUSPENDED) {
      ending.resume(returned as List<Any>)
    }
  }

  /** For the strand. */
  final override fun stack(continuation: Any): Array<StackTraceElement> =
    generateSequence(continuation as? CoroutineStackFrame) { it.callerFrame }
      .mapNotNull { it.getStackTraceElement() }
      .toList()
      .toTypedArray()

  /** Takes what callStarL returns or throws. */
  private class Ending(
    private val app: SuspendedThread,
    private val whenFinished: Consumer<List<Any>>,
  ) : Continuation<List<Any>> {
    override val context: CoroutineContext
      get() = EmptyCoroutineContext

    override fun resumeWith(result: Result<List<Any>>) {
      app.isOver = true
      whenFinished.accept(result.getOrThrow())
    }
  }
}
