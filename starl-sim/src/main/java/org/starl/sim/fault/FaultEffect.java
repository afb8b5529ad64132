package org.starl.sim.fault;

import java.util.List;

/**
 * The effect of a fault, without its times. Effects with equal texts are equal.
 *
 * @param name the name of its kind: {@code crash}
 * @param arguments in canonical form, without times
 * @param robots the affected robots; all robots for a fault of the network
 * @param named all robots in the fault's text, in any argument
 * @param action begins the fault
 */
public record FaultEffect(
    String name,
    List<String> arguments,
    RobotSelector robots,
    List<RobotSelector> named,
    FaultAction action) {

  static final String CRASH = "crash";
  static final String DATAGRAM = "datagram";

  private static final List<String> KINDS_OF_TIME = List.of("compute", "drift", "skew");

  public FaultEffect {
    arguments = List.copyOf(arguments);
    named = List.copyOf(named);
  }

  boolean isCrash() {
    return name.equals(CRASH);
  }

  /** Whether the fault needs no end: a crash, or the fate of one datagram. */
  boolean isSingle() {
    return isCrash() || name.equals(DATAGRAM);
  }

  /** Whether the fault changes a robot's time, so that the robot needs its own clock. */
  boolean changesTime() {
    return KINDS_OF_TIME.contains(name);
  }

  /** The key of the duration argument. */
  String lastingKey() {
    return lastingKey(name);
  }

  static String lastingKey(String name) {
    return name.equals(CRASH) ? "restart" : "for";
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof FaultEffect that
        && name.equals(that.name)
        && arguments.equals(that.arguments);
  }

  @Override
  public int hashCode() {
    return 31 * name.hashCode() + arguments.hashCode();
  }
}
