package org.starl.robot.file;

import static org.starl.time.Time.NS_PER_MS;

/**
 * Limits of a robot's wheels, enforced below its program, and the errors that its program expects.
 *
 * @param speedMmPerS greatest speed of a wheel
 * @param watchdogMs the wheels stop if the program gives no command for this time
 * @param positionMs the wheels stop this time after the last fix
 * @param speedError wheels turn at 0 to {@code 1 + speedError} times the commanded speed
 * @param reactionMs time until a command is in effect and the old speed is braked down
 */
public record Limits(
    double speedMmPerS, int watchdogMs, int positionMs, double speedError, int reactionMs) {

  /** Time from a robot's last fix until it stands still: stopped, and braked down. */
  public long stillAfterNs() {
    return (positionMs + reactionMs) * NS_PER_MS;
  }
}
