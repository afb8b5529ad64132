package org.starl.kotlin

import java.io.ByteArrayOutputStream
import java.util.function.BooleanSupplier
import kotlin.coroutines.resume
import kotlin.coroutines.suspendCoroutine
import org.assertj.core.api.Assertions.assertThat
import org.assertj.core.api.Assertions.assertThatThrownBy
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import org.starl.GlobalVarHolder
import org.starl.LogicThread
import org.starl.RobotApp
import org.starl.SuspendedThread
import org.starl.comms.Channel
import org.starl.comms.Codec
import org.starl.geometry.ItemPosition
import org.starl.motion.MotionFlag
import org.starl.platform.StrandClosed
import org.starl.primitives.mutex.M_Mutex
import org.starl.primitives.mutex.MutexFailure
import org.starl.primitives.mutex.MutexSpec
import org.starl.primitives.registration.Registration
import org.starl.shape.WireReader
import org.starl.sim.Simulation
import org.starl.sim.SimulationFailed
import org.starl.sim.TraceRecorder
import org.starl.sim.kernel.CarrierKind

/** An app that suspends gives the trace of one that blocks, byte for byte, on all carriers. */
class SuspendedThreadTest {

  /** Waits in every way that there is, in an order drawn from the seed, in the form that is given. */
  private class Chaotic(val gvh: GlobalVarHolder) {
    val registration = Registration(gvh, "floor")
    val mutex = M_Mutex(gvh, "floor")
    private val rng = gvh.plat.entropy.fork("chaotic")
    var heard = 0
    private val endpoint =
      gvh.comms.open(CHANNEL) { from, word ->
        heard += word
        tell("heard", from)
      }

    fun tell(what: String, vararg words: Any) {
      gvh.trace.action("app", what, *words)
    }

    fun upTo(bound: Int): Long = rng.nextInt(bound).toLong()

    fun send() {
      val others = gvh.id.participants().asList().filter { it != gvh.id.name() }
      endpoint.send(others[rng.nextInt(others.size)], 1)
    }

    fun drive() {
      gvh.plat.moat.doMove(ItemPosition("there", upTo(2000).toDouble(), upTo(2000).toDouble()))
    }

    /** Inlined into both forms, so that it blocks in one and suspends in the other. */
    inline fun run(
      sleep: (Long) -> Unit,
      await: (BooleanSupplier) -> Unit,
      awaitFor: (BooleanSupplier, Long) -> Boolean,
      register: (Long) -> Boolean,
      acquire: (List<String>, Long) -> MutexFailure,
    ): List<Any> {
      try {
        if (gvh.id.boot() > 1) {
          mutex.standsIn(setOf())
        }
        await(gvh.gps::hasFix)
        tell("registered", register(5_000))
        repeat(ROUNDS) { round ->
          val before = heard
          when (upTo(8).toInt()) {
            0 -> sleep(upTo(4) * 50)
            1 -> tell("held", awaitFor({ heard > before }, upTo(400)))
            2 -> send()
            3 -> await { true }
            4 -> {
              val atNs = gvh.plat.clock.nowNs() + 1_000_000 * upTo(300)
              await { gvh.plat.clock.nowNs() >= atNs }
            }
            5 -> {
              val outcome = acquire(listOf("dock"), 50 + upTo(3_000))
              tell("acquired", outcome)
              if (outcome == MutexFailure.NONE) {
                sleep(upTo(500))
                mutex.release("dock")
              }
            }
            6 -> {
              drive()
              awaitFor({ gvh.plat.moat.motionflag().get() != MotionFlag.MOVING }, 1_500)
            }
            else -> sleep(upTo(1_000))
          }
          tell("round", round)
        }
        return listOf(heard)
      } finally {
        tell("finally")
      }
    }
  }

  private class Blocking(gvh: GlobalVarHolder) : LogicThread(gvh) {
    private val chaotic = Chaotic(gvh)

    override fun callStarL(): List<Any> =
      chaotic.run(
        { sleep(it) },
        { await("something", it) },
        { condition, ms -> await(condition, ms) },
        { chaotic.registration.register(it) },
        { sections, ms -> chaotic.mutex.acquire(sections, ms) },
      )
  }

  private class Suspended(gvh: GlobalVarHolder) : SuspendedThread(gvh) {
    private val chaotic = Chaotic(gvh)

    override suspend fun callStarL(): List<Any> =
      chaotic.run(
        { sleep(it) },
        { await("something", it) },
        { condition, ms -> await(condition, ms) },
        { await(chaotic.registration.registering(it)) },
        { sections, ms -> await(chaotic.mutex.acquiring(sections, ms)) },
      )
  }

  private fun trace(
    carriers: CarrierKind,
    faults: List<String>,
    app: (GlobalVarHolder) -> RobotApp,
  ): String {
    val out = ByteArrayOutputStream()
    val recorder = TraceRecorder(out)
    val simulation =
      Simulation.builder().carriers(carriers).scenario {
        seed = 5
        robots(4, app)
        set("duration", "20s")
        faults { faults.forEach { +it } }
        monitor { MutexSpec() }
        observer(recorder)
      }
    val result = recorder.use { simulation.build().run() }
    return "$out${result.events()} events, ${result.network()}, ${result.results()}"
  }

  private fun assertSameTraces(
    faults: List<String>,
    blocking: (GlobalVarHolder) -> RobotApp,
    suspended: (GlobalVarHolder) -> RobotApp,
  ) {
    val expected = trace(CarrierKind.PLATFORM, faults, blocking)
    assertThat(expected.lines().size).isGreaterThan(200)
    assertThat(trace(CarrierKind.best(), faults, blocking)).isEqualTo(expected)
    for (carriers in setOf(CarrierKind.PLATFORM, CarrierKind.best())) {
      assertThat(trace(carriers, faults, suspended)).`as`("$carriers").isEqualTo(expected)
    }
  }

  @ParameterizedTest
  @ValueSource(
    strings =
      [
        "",
        "loss(0.3)",
        "compute(any,30ms) skew(bot1,2s,at=3s) drift(bot2,500ppm)",
        "compute(bot0,300ms,at=2s,for=8s) compute(bot1,120ms)",
        "crash(bot1,at=6s,restart=2s) crash(bot2,at=9s)",
      ]
  )
  fun theTracesAreEqualByteForByte(faults: String) {
    assertSameTraces(faults.split(" ").filter { it.isNotEmpty() }, ::Blocking, ::Suspended)
  }

  @Test
  fun theFormsOfTheDocumentationGiveOneTrace() {
    assertSameTraces(listOf("loss(0.2)"), { Visitor(it, 5) }, { SuspendedVisitor(it, 5) })
  }

  /** [act] ends in an error. */
  private class Failing(
    gvh: GlobalVarHolder,
    private val act: suspend Failing.() -> Unit,
  ) : SuspendedThread(gvh) {
    val mutex = M_Mutex(gvh, "dock", gvh.id.participants())

    override suspend fun callStarL(): List<Any> {
      pause()
      act()
      return listOf()
    }

    suspend fun pause() {
      sleep(100)
    }

    suspend fun holds() {
      await { true }
    }

    suspend fun never() {
      await("a miracle") { false }
    }
  }

  private fun assertFails(message: String, act: suspend Failing.() -> Unit) {
    assertThatThrownBy { simulation { robots(1) { gvh -> Failing(gvh, act) } }.run() }
      .isInstanceOf(SimulationFailed::class.java)
      .hasMessageContaining("bot0 at ")
      .hasMessageContaining(message)
  }

  @Test
  fun anExceptionEndsTheRunWithItsPlace() {
    assertFails("0.100000000 s: IllegalStateException: a bug; at SuspendedThreadTest.kt:") {
      error("a bug")
    }
    assertFails("0.200000000 s: NoSuchElementException: List is empty.; at SuspendedThreadTest.kt:") {
      pause()
      holds()
      listOf<Int>().first()
    }
  }

  @Test
  fun aBlockingCallNamesItsSuspendingForm() {
    assertFails("bot0: a blocking call in an app that suspends: expected its suspending form, as in") {
      mutex.acquire(listOf("dock"), 1_000)
    }
  }

  @Test
  fun anotherSuspensionIsRefused() {
    assertFails("callStarL suspends outside sleep and await") {
      suspendCoroutine<Unit> { elsewhere = { it.resume(Unit) } }
    }
  }

  @Test
  fun anEndlessLoopOfConditionsThatHoldIsRefused() {
    assertFails("awaits in one action, whose conditions held at once") {
      while (true) {
        holds()
      }
    }
  }

  @Test
  fun anAppThatCatchesItsEndIsReported() {
    assertFails("does it catch StrandClosed?") {
      while (true) {
        try {
          never()
        } catch (e: StrandClosed) {
          tellCaught()
        }
      }
    }
  }

  @Test
  fun whereItWaitsIsTold() {
    val result = simulation {
      robots(1) { gvh -> Failing(gvh) { never() } }
      set("duration", "2s")
    }.run()
    assertThat(result.diagnosis().robots().map { it.lines().first() })
      .singleElement()
      .asString()
      .matches("bot0 waits at SuspendedThreadTest.kt:\\d+ \\(.+\\) since 0.100 s for: a miracle")
  }

  private fun tellCaught() {
    caught++
  }

  private var caught = 0
  private var elsewhere = {}

  private companion object {
    const val ROUNDS = 60
    val CHANNEL = Channel<Int>("test", "both", Codec.of({ word, out -> out.u8(word) }, WireReader::u8))
  }
}
