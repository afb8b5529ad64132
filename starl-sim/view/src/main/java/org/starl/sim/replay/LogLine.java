package org.starl.sim.replay;

import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;

/**
 * A log line of a robot's program. Only recordings of live runs have log lines; traces do not.
 *
 * @param index number of events before it
 */
public record LogLine(
    long timeNs, int index, RobotId robot, Level level, String tag, String line) {}
