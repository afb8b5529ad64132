package org.starl.sim;

import org.starl.id.RobotId;

/**
 * Lets a {@link StepListener} intervene in a run. Each call takes effect at once, between two steps, and
 * is an event of the trace, {@link org.starl.trace.TraceEvent.Intervention}.
 */
public interface RunController {

  long nowNs();

  /** Number of steps so far. Several steps may have the same time. */
  long steps();

  /**
   * Injects a fault. It begins now, unless it names a time.
   *
   * @param fault as {@code --fault} reads it
   * @throws org.starl.input.BadInput if it is not a fault, names a robot that has never joined,
   *     or would end before it begins; then nothing has happened
   */
  void fault(String fault);

  /**
   * Shows a robot's app a place: {@link org.starl.LogicThread#receivedPointInput}. A robot that is
   * down does not see it.
   *
   * @throws org.starl.input.BadInput if there is no such robot; then nothing has happened
   */
  void point(RobotId robot, int xMm, int yMm);

  /** Ends the run: this is its last step. */
  void stop();
}
