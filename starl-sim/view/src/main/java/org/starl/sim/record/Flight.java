package org.starl.sim.record;

import org.starl.id.RobotId;

/**
 * A datagram in transit to one robot.
 *
 * @param channel primitive and instance, as in the trace
 * @param text the message as text
 * @param share share of the way that is done, 0 to 1
 */
public record Flight(
    RobotId from, RobotId to, String channel, String text, double share, State state) {

  /** State of a datagram; delivered and dropped ones are shown for a moment. */
  public enum State {
    IN_TRANSIT,
    DELIVERED,
    /** Lost, or rejected by the receiver. */
    DROPPED
  }

  /** The first word of the message: {@code Prepare} of {@code Prepare[number=1]}. */
  public String title() {
    int end = 0;
    while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return text.substring(0, end);
  }
}
