package org.starl.robot.create;

import java.util.Set;
import org.starl.body.WheelCommand;

/** What is left of a command under what holds the wheels, as whole mm/s of each wheel. */
final class WheelLimit {

  private WheelLimit() {}

  /** What {@code holds} leave of {@code command}. */
  static WheelCommand under(Set<CreateHold> holds, WheelCommand command) {
    for (CreateHold hold : holds) {
      if (hold.isWhole()) {
        return WheelCommand.STOP;
      }
    }
    double linear = command.linearMmPerS();
    double angular = command.angularRadPerS();
    if (holds.contains(CreateHold.CLIFF)) {
      // A wheel that turns on the spot may go over the edge; so may one on a narrow way back.
      return new WheelCommand(Math.min(linear, 0), 0);
    }
    return holds.contains(CreateHold.BUMP)
        ? new WheelCommand(Math.min(linear, 0), angular)
        : command;
  }

  /** How much of the wheel speeds is possible: both are slowed alike, so that the curve stays. */
  static double factor(WheelCommand command, double axleMm, double maxMmPerS) {
    double fastest =
        Math.max(Math.abs(command.leftMmPerS(axleMm)), Math.abs(command.rightMmPerS(axleMm)));
    return fastest > maxMmPerS ? maxMmPerS / fastest : 1;
  }
}
