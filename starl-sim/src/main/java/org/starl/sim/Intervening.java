package org.starl.sim;

import org.starl.id.RobotId;

/**
 * A {@link Bystander}'s hands. What they do takes effect here and now, between two steps, and is an
 * event of the run, {@link org.starl.trace.TraceEvent.Intervention}.
 */
public interface Intervening {

  long nowNs();

  /** How many steps the run has made: tells one place from another where time does not. */
  long steps();

  /**
   * Lets a fault happen; what it does not say of times counts from now.
   *
   * @param fault as {@code --fault} reads it
   * @throws org.starl.input.BadInput if it is none, names a robot that never was there, or would
   *     end before it begins; then nothing has happened
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
