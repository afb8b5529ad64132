package org.starl.sim;

/** The settings contradict what a robot's program needs at its start: the run is refused. */
final class UnmetNeeds extends RuntimeException {

  private static final long serialVersionUID = 1L;

  UnmetNeeds(String message) {
    super(message);
  }
}
