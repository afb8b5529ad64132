package org.starl.primitives.mutex;

/** Why a request ended without access. */
public enum MutexFailure {
  /** It did not fail: it waits, has access, or there is none. */
  NONE,
  /** This robot stands in no view that it has learned, or has begun to leave. */
  NOT_REGISTERED,
  /** Somebody's answer did not come in time. */
  DEADLINE,
  /** The app withdrew it. */
  WITHDRAWN,
  /** A later view does not list this robot's participant, or it registered anew. */
  REMOVED
}
