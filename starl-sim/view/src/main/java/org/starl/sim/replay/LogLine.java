package org.starl.sim.replay;

import org.starl.id.RobotId;

/**
 * A log line of a robot's program. Only live runs have them; traces do not contain log lines.
 *
 * @param index number of events before it
 */
public record LogLine(long timeNs, int index, RobotId robot, String tag, String line) {}
