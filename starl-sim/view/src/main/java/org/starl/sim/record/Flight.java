package org.starl.sim.record;

import org.starl.id.RobotId;
import org.starl.trace.Instance;

/**
 * A datagram in transit to one robot.
 *
 * @param share share of the way that is done, 0 to 1
 */
public record Flight(
    RobotId from, RobotId to, Instance channel, Object message, double share, State state) {

  /** State of a datagram; delivered and dropped ones are shown for a moment. */
  public enum State {
    IN_TRANSIT,
    DELIVERED,
    /** Lost, or rejected by the receiver. */
    DROPPED
  }

  /** The first word of the message: {@code Prepare} of {@code Prepare[number=1]}. */
  public String title() {
    String text = message.toString();
    int end = 0;
    while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return text.substring(0, end);
  }
}
