package org.starl.primitives.paths;

/** The result of a planner. */
public sealed interface Plan {

  /** A path. */
  record Found(Path path) implements Plan {}

  /** A proof that there is no path. */
  record NoPath() implements Plan {}

  /** The planner found no path within its limit; there may be one. */
  record GaveUp() implements Plan {}

  /** One end is not free: outside the floor, in an obstacle, or too close to one. */
  record Blocked(End end) implements Plan {}

  /** An end of the path. */
  enum End {
    START,
    GOAL
  }
}
