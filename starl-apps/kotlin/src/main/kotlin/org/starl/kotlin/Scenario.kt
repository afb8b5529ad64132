package org.starl.kotlin

import org.starl.GlobalVarHolder
import org.starl.LogicThread
import org.starl.id.RobotId
import org.starl.geometry.Obstacle
import org.starl.geometry.Pose
import org.starl.sim.RobotSpec
import org.starl.sim.Setting
import org.starl.sim.SimObserver
import org.starl.sim.SimSettings
import org.starl.sim.Simulation
import org.starl.sim.fault.Envelope
import org.starl.spec.Monitor

@DslMarker internal annotation class ScenarioDsl

/**
 * A simulation that [fill] describes, ready to run:
 * ```
 * val result = simulation {
 *   seed = 7
 *   robots(4) { gvh -> Hello(gvh) }
 *   network { loss(0.1) }
 *   faults { +"crash(bot2,at=12s,restart=5s)" }
 *   monitor { MutexSpec("dock") }
 * }.run()
 * ```
 *
 * It is a thin layer over [Simulation.Builder]: what that refuses is refused here, with the same line.
 */
public fun simulation(fill: ScenarioScope.() -> Unit): Simulation =
  Simulation.builder().scenario(fill).build()

/** Adds what [fill] describes: for a builder that comes from elsewhere, as a `@StarlTest`'s does. */
public fun Simulation.Builder.scenario(fill: ScenarioScope.() -> Unit): Simulation.Builder {
  ScenarioScope(this).fill()
  return this
}

/** What a scenario consists of; see [simulation]. */
@ScenarioDsl
public class ScenarioScope internal constructor(private val builder: Simulation.Builder) {

  /** Decides places, and all else by chance; 0 unless set. */
  public var seed: Long = 0
    set(value) {
      field = value
      builder.seed(value)
    }

  /** The app's or scenario's name, for traces and messages. */
  public fun name(name: String) {
    builder.name(name)
  }

  /** [count] robots `bot0`, `bot1`, ... at free places drawn by seed, each with an [app] of its own. */
  public fun robots(count: Int, app: (GlobalVarHolder) -> LogicThread) {
    builder.robots(count, app)
  }

  /** One robot, on the floor from the start. */
  public fun robot(name: String, start: Pose, app: (GlobalVarHolder) -> LogicThread) {
    builder.robot(RobotSpec(RobotId(name), start, true, app))
  }

  /** An obstacle, besides those that are there. */
  public fun obstacle(obstacle: Obstacle) {
    builder.obstacles(builder.obstacles().plus(obstacle))
  }

  /** Sets one of the simulator's settings. */
  public fun <T : Any> set(setting: Setting<T>, value: T) {
    settings { set(setting, value) }
  }

  /** Sets one of them by text, as `--set key=value` does: `set("positionNoise", "20mm")`. */
  public fun set(key: String, value: String) {
    settings { set(key, value) }
  }

  /** How datagrams fare. */
  public fun network(fill: NetworkScope.() -> Unit) {
    NetworkScope(this).fill()
  }

  /** What goes wrong. */
  public fun faults(fill: FaultScope.() -> Unit) {
    FaultScope(builder, this).fill()
  }

  /** A specification to watch the run: [make] gives a new one. */
  public fun monitor(make: () -> Monitor) {
    builder.monitor(make)
  }

  /** Somebody who sees the run, and changes nothing. */
  public fun observer(observer: SimObserver) {
    builder.observer(observer)
  }

  private fun settings(change: SimSettings.Builder.() -> Unit) {
    builder.settings(builder.settings().toBuilder().apply(change).build())
  }
}

/** How datagrams fare; see [ScenarioScope.network]. */
@ScenarioDsl
public class NetworkScope internal constructor(private val scenario: ScenarioScope) {

  /** Each recipient loses a datagram with this probability. */
  public fun loss(probability: Double) {
    scenario.set(Setting.MESSAGE_LOSS, probability)
  }

  /** How long a datagram takes: `100ms`, `uniform(10ms,200ms)`, `normal(..)`, `exponential(..)`. */
  public fun delay(distribution: String) {
    scenario.set(Setting.MESSAGE_DELAY.key(), distribution)
  }
}

/** What goes wrong; see [ScenarioScope.faults]. */
@ScenarioDsl
public class FaultScope
internal constructor(private val builder: Simulation.Builder, private val scenario: ScenarioScope) {

  /** One fault, in the grammar that `starl list` shows: `+"crash(bot2,at=12s)"`. */
  public operator fun String.unaryPlus() {
    builder.fault(this)
  }

  /** Faults drawn by seed from an envelope. */
  public fun chaos(envelope: Envelope) {
    scenario.set(Setting.CHAOS, envelope)
  }
}
