package org.starl.robot.file;

/**
 * What a robot's wheels may do, kept below its program, and what its program has to expect of them.
 *
 * @param speedMmPerS no wheel turns faster
 * @param watchdogMs a program that has said nothing for so long has its wheels stopped
 * @param positionMs so long after the last fix the wheels are stopped
 * @param speedError they drive and turn from not at all to {@code 1 + speedError} times as fast as
 *     commanded
 * @param reactionMs what the program commands is in effect, the old speed braked down, within this time
 */
public record Limits(
    double speedMmPerS, int watchdogMs, int positionMs, double speedError, int reactionMs) {

  private static final long NS_PER_MS = 1_000_000;

  /** So long after the time of its last fix a robot stands: stopped, and braked down. */
  public long stillAfterNs() {
    return (positionMs + reactionMs) * NS_PER_MS;
  }
}
