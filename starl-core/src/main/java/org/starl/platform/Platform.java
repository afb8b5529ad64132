package org.starl.platform;

import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.trace.TraceSink;

/**
 * All that one robot stands on. A platform is this bundle of ports and nothing else; {@link
 * org.starl.RobotRunner} builds the robot's {@link org.starl.GlobalVarHolder} over it.
 *
 * @param id who this robot is
 * @param deployment all robots that the deployment knows at its start; others may join later
 * @param knownObstacles the map that the robot has at its start; hidden obstacles are not on it
 * @param motionParameters how this robot moves unless its app says otherwise
 * @param key what this deployment's datagrams are sealed with; null for none
 */
public record Platform(
    RobotId id,
    Participants deployment,
    Clock clock,
    Timers timers,
    Strand strand,
    Radio radio,
    Positioning positioning,
    Chassis chassis,
    Stable stable,
    Entropy entropy,
    Background background,
    LogSink log,
    TraceSink trace,
    Obstacles knownObstacles,
    MotionParameters motionParameters,
    @Nullable DeploymentKey key) {}
