package org.starl.robot.optitrack;

/** Reasons to drop a datagram, or a body in it. */
public enum FeedDrop {
  /** It comes from another address than the server's. */
  FOREIGN,

  /** Its bytes violate the protocol: cut off, or with impossible counts or sizes. */
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

  /** The robot's wheels hang: it is off the floor, and has no place. */
  LIFTED,

  /** No robot drives so fast from its last fix to this one, or its wheels turned otherwise. */
  JUMPED,

  /** Other poses of the same body contradict it. */
  DOUBTED,

  /** It is not authenticated with the feed's key. */
  FORGED,

  /** It is authenticated, but not newer than the one before it, or of another run. */
  REPLAYED,

  /** There are more bodies than a feed handles. */
  TOO_MANY
}
