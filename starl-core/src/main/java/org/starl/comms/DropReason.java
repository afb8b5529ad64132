package org.starl.comms;

import java.util.Locale;

/** Why a received datagram was dropped. */
public enum DropReason {
  /** Not sealed, or not by the robot that it names. */
  FORGED(true),
  /** Sealed, but this robot has no session with its sender yet. */
  NO_SESSION(false),
  /** Sealed in another session: before a restart of either robot, or in another run. */
  OTHER_SESSION(false),
  /** Sealed in this session, but received before, or older than the replay window. */
  REPLAYED(false),
  /** Shorter than its length field, or than any datagram. */
  TRUNCATED(true),
  /** Longer than its length field, or than any datagram may be. */
  OVERLONG(true),
  /** Not a StarL datagram. */
  FOREIGN(true),
  /** Another version of the wire format. */
  OTHER_VERSION(true),
  /** A kind that this version does not have. */
  UNKNOWN_KIND(true),
  /** A number in the header is out of range. */
  BAD_FIELD(true),
  /** The sender's or the channel's name is invalid. */
  BAD_NAME(true),
  /** The channel's codec rejects the payload, or leaves bytes unread. */
  BAD_PAYLOAD(true),
  /** More senders than the 65,536 that this robot can track. */
  TOO_MANY_SENDERS(true),
  /** Addressed to another robot. */
  NOT_FOR_US(false),
  /** Sent by this robot itself and echoed by the network. */
  OWN(false),
  /** Sent by an incarnation that has a successor. */
  DEAD_SENDER(false),
  /** The channel is not open here. */
  NO_LISTENER(false),
  /** A reliable message that was handled before; it is acknowledged again. */
  DUPLICATE(false),
  /** A reliable message older than the window: unknown whether it was handled. */
  TOO_OLD(false),
  /** An acknowledgement of a message that is settled already, or was sent before a restart. */
  STALE_ACK(false);

  private final boolean suspicious;
  private final String text;

  DropReason(boolean suspicious) {
    this.suspicious = suspicious;
    this.text = name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * Whether it indicates a faulty or foreign sender: a network of correct robots never causes it.
   */
  public boolean isSuspicious() {
    return suspicious;
  }

  /** The reason's text in the trace and the log: {@code no-listener}. */
  @Override
  public String toString() {
    return text;
  }
}
