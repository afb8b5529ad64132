package org.starl.robot.create;

import java.util.Set;
import org.starl.body.WheelCommand;

/** Limits a command by the reasons that hold the wheels, to whole mm/s of each wheel. */
final class WheelLimit {

  private WheelLimit() {}

  /** The part of {@code command} that {@code holds} allow. */
  static WheelCommand under(Set<CreateHold> holds, WheelCommand command) {
    if (holds.stream().anyMatch(CreateHold::isWhole)) {
      return WheelCommand.STOP;
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

  /** The possible fraction of the wheel speeds: both are slowed alike, so that the curve stays. */
  static double factor(WheelCommand command, double axleMm, double maxMmPerS) {
    double fastest =
        Math.max(Math.abs(command.leftMmPerS(axleMm)), Math.abs(command.rightMmPerS(axleMm)));
    return fastest > maxMmPerS ? maxMmPerS / fastest : 1;
  }
}
