package org.starl.comms;

import java.util.Locale;

/** Why a datagram that arrived came to nothing. */
public enum DropReason {
  /** Not sealed with the deployment's key. */
  FORGED(true),
  /** Sealed, but arrived before, or so long ago that nobody knows. */
  REPLAYED(false),
  /** Shorter than it says, or than any datagram is. */
  TRUNCATED(true),
  /** Longer than it says, or than any datagram may be. */
  OVERLONG(true),
  /** Not StarL's. */
  FOREIGN(true),
  /** Of another version of the wire format. */
  OTHER_VERSION(true),
  /** Of a kind that this version does not have. */
  UNKNOWN_KIND(true),
  /** A number in the header is out of its range. */
  BAD_FIELD(true),
  /** The name of the sender or of the channel is none. */
  BAD_NAME(true),
  /** The channel's codec refuses the payload, or leaves bytes over. */
  BAD_PAYLOAD(true),
  /** More senders than the 65,536 that this robot keeps in mind. */
  TOO_MANY_SENDERS(true),
  /** Addressed to another robot. */
  NOT_FOR_US(false),
  /** This robot's own, echoed. */
  OWN(false),
  /** From an incarnation of its sender that has a successor. */
  DEAD_SENDER(false),
  /** The channel is not open here. */
  NO_LISTENER(false),
  /** A reliable message that was handled before; it is acknowledged again. */
  DUPLICATE(false),
  /** A reliable message so old that nobody knows whether it was handled. */
  TOO_OLD(false),
  /** An acknowledgement of what is settled, or was sent before a restart. */
  STALE_ACK(false);

  private final boolean suspicious;
  private final String text;

  DropReason(boolean suspicious) {
    this.suspicious = suspicious;
    this.text = name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Whether a network of well-behaved robots never shows it. */
  boolean isSuspicious() {
    return suspicious;
  }

  /** As in the trace and the log: {@code no-listener}. */
  @Override
  public String toString() {
    return text;
  }
}
