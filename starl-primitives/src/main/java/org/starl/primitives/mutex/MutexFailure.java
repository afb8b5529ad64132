package org.starl.primitives.mutex;

/** Why a request ended without access. */
public enum MutexFailure {
  /** It did not fail: it waits, has access, or there is none. */
  NONE(false),
  /** This robot stands in no view that it has learned, or has begun to leave. */
  NOT_REGISTERED(true),
  /** Somebody's answer did not come in time. */
  DEADLINE(false),
  /**
   * A section is occupied by a ghost: by one who seems to have crashed inside, and may stand there.
   */
  OCCUPIED(false),
  /** The app withdrew it. */
  WITHDRAWN(false),
  /** A later view does not list this robot's participant, or it registered anew. */
  REMOVED(true),
  /** Somebody took this robot's participant for crashed, and will never answer it again. */
  FENCED(true);

  private final boolean mustRegister;

  MutexFailure(boolean mustRegister) {
    this.mustRegister = mustRegister;
  }

  /**
   * Whether this robot's participant is over: only after a new {@code do_register} is it of use to
   * ask again.
   */
  public boolean mustRegister() {
    return mustRegister;
  }
}
