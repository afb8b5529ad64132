package org.starl.android.app;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.motion.Location;
import org.starl.robot.create.CreateStatus;
import org.starl.robot.realtime.StrandUse;
import org.starl.robot.udp.UdpStatistics;

/**
 * A robot's state. Immutable.
 *
 * @param appState the state of its app
 * @param location its own estimate; null before its start
 * @param linkProblem why there is no link to its wheels; null if there is one, or not known yet
 * @param bug the error that ended it; null while it runs
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
