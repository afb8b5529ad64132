package org.starl.android.app;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.motion.Location;
import org.starl.robot.create.CreateStatus;
import org.starl.robot.realtime.StrandUse;
import org.starl.robot.udp.UdpStatistics;

/**
 * How a robot fares. Immutable.
 *
 * @param appState what its app does
 * @param location where it is as far as it knows; null before it is up
 * @param linkProblem why there is no link to its wheels; null if there is one, or nobody knows yet
 * @param bug what it cannot go on after; null if it goes on
 */
record RobotStatus(
    RobotId robot,
    String app,
    String appState,
    @Nullable Location location,
    CreateStatus wheels,
    @Nullable IOException linkProblem,
    UdpStatistics radio,
    StrandUse strand,
    @Nullable Throwable bug) {}
