package org.starl.sim.fault;

import java.util.List;

/** What a fault does while it lasts, when it does not matter. Immutable. */
public sealed interface Harm permits AirHarm, RobotHarm, IntruderHarm, AttackHarm, Crash {

  /** As in its text: {@code crash}. */
  String name();

  /** Its arguments as text, times aside. */
  List<String> arguments();

  /** Whom it befalls; all for what befalls the air. */
  Who who();

  /** Everybody whom its text names, in whatever part. */
  default List<Who> named() {
    return List.of(who());
  }

  /** Does it, until the returned cure runs. */
  Runnable begin(Onset onset);

  /** The name of the argument that says how long it lasts. */
  default String lastingKey() {
    return "for";
  }
}
