package org.starl.sim.fault;

import java.util.List;

/** The effect of a fault, without its times. Immutable. */
public sealed interface FaultEffect
    permits NetworkFault, RobotFault, IntruderFault, AttackFault, Crash {

  /** The name in its text: {@code crash}. */
  String name();

  /** Its arguments as text, without times. */
  List<String> arguments();

  /** The affected robots; all robots for a fault of the network. */
  RobotSelector who();

  /** All robots in the fault's text, in any argument. */
  default List<RobotSelector> named() {
    return List.of(who());
  }

  /** Begins the fault; the returned cure ends it. */
  Runnable begin(FaultContext onset);

  /** The key of the duration argument. */
  default String lastingKey() {
    return "for";
  }
}
