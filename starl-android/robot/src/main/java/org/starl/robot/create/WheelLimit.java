package org.starl.robot.create;

import java.util.Set;
import org.starl.body.WheelCommand;

/** Limits a command by the reasons that hold the wheels, to whole mm/s of each wheel. */
final class WheelLimit {

  private WheelLimit() {}

  /** {@code command}, limited by {@code holds}. */
  static WheelCommand under(Set<CreateHold> holds, WheelCommand command) {
    if (holds.stream().anyMatch(CreateHold::isWhole)) {
      return WheelCommand.STOP;
    }
    double linear = command.linearMmPerS();
    double angular = command.angularRadPerS();
    if (holds.contains(CreateHold.CLIFF)) {
      // A turn on the spot or a narrow backward curve may take a wheel over the edge.
      return new WheelCommand(Math.min(linear, 0), 0);
    }
    return holds.contains(CreateHold.BUMP)
        ? new WheelCommand(Math.min(linear, 0), angular)
        : command;
  }

  /** The possible fraction of the commanded speeds, the same for both wheels to keep the curve. */
  static double factor(WheelCommand command, double axleMm, double maxMmPerS) {
    double fastest = command.fastestMmPerS(axleMm);
    return fastest > maxMmPerS ? maxMmPerS / fastest : 1;
  }
}
