package org.starl.sim;

/**
 * An app, a primitive or the simulator threw an exception. The message names robot, time and seed.
 */
public final class SimulationFailed extends RuntimeException {

  private static final long serialVersionUID = 1L;

  SimulationFailed(String message, Throwable cause) {
    super(message, cause);
  }
}
