package org.starl.primitives.mutex;

/** Why a request ended without access. */
public enum MutexFailure {
  /** No failure: the request waits or has access, or there is no request. */
  NONE(false),
  /** This robot is in no view that it has learned, or has begun to leave. */
  NOT_REGISTERED(true),
  /** A needed answer did not arrive in time. */
  DEADLINE(false),
  /** A ghost occupies a section: a robot that seems to have crashed inside may still be there. */
  OCCUPIED(false),
  /**
   * Its logical time is earlier than that of a process that holds a section and waits for others, or a
   * robot in the way has started again. The request held nothing; ask again.
   */
  LATE(false),
  /** The app withdrew the request. */
  WITHDRAWN(false),
  /** A later view does not list this robot's participant, or the robot has registered again. */
  REMOVED(true),
  /** Another participant has fenced this robot's one as crashed, and never answers it again. */
  FENCED(true);

  private final boolean mustRegister;

  MutexFailure(boolean mustRegister) {
    this.mustRegister = mustRegister;
  }

  /**
   * Whether this robot's participant has ended: the robot can request again only after a new {@code
   * do_register}.
   */
  public boolean mustRegister() {
    return mustRegister;
  }
}
