package org.starl.robot.optitrack;

/** Why a feed did not use a datagram, or a body in it. */
public enum FeedDrop {
  /** Not from the server's address. */
  FOREIGN,

  /** No bytes of the protocol: cut off, or with counts or sizes that cannot be. */
  MALFORMED,

  /** A message that this side does not expect, or of a version that it cannot read. */
  UNKNOWN,

  /** It came before the server had introduced itself, or before its clock was known. */
  EARLY,

  /** Its numbers are none that a robot on a floor can have, or it speaks of the future. */
  IMPLAUSIBLE,

  /** Two bodies have this number, or this name. */
  AMBIGUOUS,

  /** It was measured too long ago. */
  STALE,

  /** Measured before the fix that came before it. */
  OUTDATED,

  /** The cameras have lost the body. */
  LOST,

  /** More bodies than a feed keeps apart. */
  TOO_MANY
}
