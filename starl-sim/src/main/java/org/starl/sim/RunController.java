package org.starl.sim;

import org.starl.id.RobotId;

/**
 * Lets a {@link StepListener} intervene in a run. Each call takes effect at once, between two
 * steps, and is an event of the trace, {@link org.starl.trace.TraceEvent.Intervention}.
 */
public interface RunController {

  long nowNs();

  /** Number of steps so far. Several steps may have the same time. */
  long steps();

  /**
   * Injects a fault, which begins now unless its text contains a time.
   *
   * @param fault in the format of {@code --fault}
   * @throws org.starl.input.BadInput if the text is not a fault, names a robot that has never
   *     joined, or ends before it begins; the run is then unchanged
   */
  void fault(String fault);

  /**
   * Passes a point to a robot's app: {@link org.starl.RobotApp#receivedPointInput}. A robot that
   * is down ignores it.
   *
   * @throws org.starl.input.BadInput if there is no such robot; the run is then unchanged
   */
  void point(RobotId robot, int xMm, int yMm);

  /** Ends the run: this is its last step. */
  void stop();
}
