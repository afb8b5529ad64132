package org.starl.sim.record;

import org.starl.id.RobotId;
import org.starl.trace.Instance;

/**
 * A datagram in transit to one robot.
 *
 * @param title the name of its message
 * @param share share of the way that is done, 0 to 1
 */
public record Flight(
    RobotId from, RobotId to, Instance channel, String title, double share, State state) {

  /** State of a datagram; delivered and dropped ones are shown for a moment. */
  public enum State {
    IN_TRANSIT,
    DELIVERED,
    /** Lost, or rejected by the receiver. */
    DROPPED
  }
}
