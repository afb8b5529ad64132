package org.starl.platform;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.session.Sessions;
import org.starl.trace.TraceSink;

/**
 * The ports under one robot, and nothing else; {@link org.starl.RobotRunner} builds the robot's
 * {@link org.starl.GlobalVarHolder} on it.
 *
 * @param id this robot's name
 * @param deployment all robots that the deployment knows at its start; others may join later
 * @param knownObstacles the robot's map at its start, without hidden obstacles
 * @param waypoints named places on the floor, the same for every robot
 * @param motionParameters the motion parameters until the app sets others
 * @param sessions seal the datagrams to and from other robots; null: datagrams are not sealed
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
    ObjectSensor objects,
    Light light,
    StableStorage stable,
    Entropy entropy,
    Background background,
    LogSink log,
    TraceSink trace,
    Obstacles knownObstacles,
    List<ItemPosition> waypoints,
    MotionParameters motionParameters,
    @Nullable Sessions sessions) {}
