package org.starl.sim;

/** A run that an error of an app, a primitive or the simulator ended; says where, and the seed. */
public final class SimulationFailed extends RuntimeException {

  private static final long serialVersionUID = 1L;

  SimulationFailed(String message, Throwable cause) {
    super(message, cause);
  }
}
