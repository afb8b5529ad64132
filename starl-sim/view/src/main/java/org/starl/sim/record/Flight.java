package org.starl.sim.record;

import org.starl.id.RobotId;

/**
 * A datagram on its way to one robot, to be painted.
 *
 * @param channel as in the trace: primitive and instance
 * @param text the message, for people
 * @param sentNs when it was handed to the radio
 * @param share of its way that it has behind it, 0 to 1
 * @param state how it stands
 */
public record Flight(
    RobotId from, RobotId to, String channel, String text, long sentNs, double share, State state) {

  /** The state of a datagram. */
  public enum State {
    UNDER_WAY,
    /** A moment ago. */
    DELIVERED,
    /** It was lost, or refused; a moment ago. */
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
