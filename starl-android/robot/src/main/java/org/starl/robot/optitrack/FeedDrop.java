package org.starl.robot.optitrack;

/** Why a feed did not use a datagram, or a body in it. */
public enum FeedDrop {
  /** It does not come from the server's address. */
  FOREIGN,

  /** Its bytes are not of the protocol: cut off, or with impossible counts or sizes. */
  MALFORMED,

  /** It is an unexpected message, or of a version that cannot be read. */
  UNKNOWN,

  /** It arrived before the server's description, or before the server's clock was known. */
  EARLY,

  /** Its numbers are impossible for a robot on a floor, or its time is in the future. */
  IMPLAUSIBLE,

  /** Two bodies have the same number or name. */
  AMBIGUOUS,

  /** It was measured too long ago. */
  STALE,

  /** It was measured before the last fix. */
  OUTDATED,

  /** The cameras have lost the body. */
  LOST,

  /** There are more bodies than a feed handles. */
  TOO_MANY
}
