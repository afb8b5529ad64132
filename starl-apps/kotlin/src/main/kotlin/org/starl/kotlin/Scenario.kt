package org.starl.kotlin

import org.starl.GlobalVarHolder
import org.starl.RobotApp
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
 *   monitor { MutexSpec() }
 * }.run()
 * ```
 *
 * It is a thin layer over [Simulation.Builder]: it refuses the same values, with the same messages.
 */
public fun simulation(fill: ScenarioScope.() -> Unit): Simulation =
  Simulation.builder().scenario(fill).build()

/** Adds the scenario of [fill] to a builder, such as that of a `@StarlTest`. */
public fun Simulation.Builder.scenario(fill: ScenarioScope.() -> Unit): Simulation.Builder {
  ScenarioScope(this).fill()
  return this
}

/** The parts of a scenario; see [simulation]. */
@ScenarioDsl
public class ScenarioScope internal constructor(private val builder: Simulation.Builder) {

  /** Seed of start places and of all other randomness; 0 by default. */
  public var seed: Long = 0
    set(value) {
      field = value
      builder.seed(value)
    }

  /** The app's or scenario's name, for traces and messages. */
  public fun name(name: String) {
    builder.name(name)
  }

  /** [count] robots `bot0`, `bot1`, ... at free places drawn by seed, each with its own [app]. */
  public fun robots(count: Int, app: (GlobalVarHolder) -> RobotApp) {
    builder.robots(count, app)
  }

  /** One robot, on the floor from the start. */
  public fun robot(name: String, start: Pose, app: (GlobalVarHolder) -> RobotApp) {
    builder.robot(RobotSpec(RobotId(name), start, true, app))
  }

  /** Adds an obstacle. */
  public fun obstacle(obstacle: Obstacle) {
    builder.obstacles(builder.obstacles().plus(obstacle))
  }

  /** Sets one of the simulator's settings. */
  public fun <T : Any> set(setting: Setting<T>, value: T) {
    settings { set(setting, value) }
  }

  /** Sets a setting by text, as `--set key=value` does: `set("positionNoise", "20mm")`. */
  public fun set(key: String, value: String) {
    settings { set(key, value) }
  }

  /** Loss and delay of datagrams. */
  public fun network(fill: NetworkScope.() -> Unit) {
    NetworkScope(this).fill()
  }

  /** Faults of the run. */
  public fun faults(fill: FaultScope.() -> Unit) {
    FaultScope(builder, this).fill()
  }

  /** Adds a specification that checks the run; [make] makes its monitor. */
  public fun monitor(make: () -> Monitor) {
    builder.monitor(make)
  }

  /** An observer of the run. It must not change the run. */
  public fun observer(observer: SimObserver) {
    builder.observer(observer)
  }

  private fun settings(change: SimSettings.Builder.() -> Unit) {
    builder.settings(builder.settings().toBuilder().apply(change).build())
  }
}

/** Loss and delay of datagrams; see [ScenarioScope.network]. */
@ScenarioDsl
public class NetworkScope internal constructor(private val scenario: ScenarioScope) {

  /** Each recipient loses a datagram with this probability. */
  public fun loss(probability: Double) {
    scenario.set(Setting.MESSAGE_LOSS, probability)
  }

  /** Delay of a datagram: `100ms`, `uniform(10ms,200ms)`, `normal(..)`, `exponential(..)`. */
  public fun delay(distribution: String) {
    scenario.set(Setting.MESSAGE_DELAY.key(), distribution)
  }
}

/** Faults of the run; see [ScenarioScope.faults]. */
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
