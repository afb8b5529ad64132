package org.starl.sim.replay;

import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;

/**
 * A line that a robot's program wrote for people. A trace has none: only a run that is watched does.
 *
 * @param index how many events came before it
 */
public record LogLine(
    long timeNs, int index, RobotId robot, Level level, String tag, String line) {}
