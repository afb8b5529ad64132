package org.starl.primitives.paths;

/** What a planner has to say. */
public sealed interface Plan {

  /** There is a path, and this is one. */
  record Found(Path path) implements Plan {}

  /** Proven: there is no path. */
  record NoPath() implements Plan {}

  /** None was found within the planner's limit; there may be one. */
  record GaveUp(int iterations) implements Plan {}

  /** One end of the way is not free: off the floor, in an obstacle, or too near to one. */
  record Blocked(End end) implements Plan {}

  /** An end of the way. */
  enum End {
    START,
    GOAL
  }
}
