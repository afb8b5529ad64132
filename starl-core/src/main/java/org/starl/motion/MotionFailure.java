package org.starl.motion;

/** Why a motion failed. {@link #toString} says it in words for people. */
public enum MotionFailure {
  /** At the target the body would touch the region to avoid. */
  TARGET_FORBIDDEN("the target is in the region to avoid"),
  /** The body cannot go on, in the allowed time, without a risk to touch the region to avoid. */
  IN_THE_WAY("the region to avoid is in the way"),
  /** No way leads past the region to avoid and the known obstacles. */
  NO_WAY("no way to the target"),
  /** The body touched something, and the collision policy is to fail. */
  BUMPED("bumped into something"),
  /** The wheels turn, and the body does not come nearer to the target. */
  NO_PROGRESS("no progress"),
  /** The motion has taken longer than the longest time for its distance. */
  TOO_SLOW("too slow"),
  /** There is no fix, or the last one is too old. */
  NO_FIX("no position fix"),
  /** The error bound of the position is too large. */
  UNCERTAIN("the position is too uncertain"),
  /** The body does not do what it is told: it was carried, or its wheels slip or are stuck. */
  CONTRADICTED("fixes contradict the commands");

  private final String words;

  MotionFailure(String words) {
    this.words = words;
  }

  @Override
  public String toString() {
    return words;
  }
}
