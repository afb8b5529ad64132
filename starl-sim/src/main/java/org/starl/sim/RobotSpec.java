package org.starl.sim;

import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * One robot of a simulation.
 *
 * @param start pose of its body when it is put on the floor
 * @param onFloor whether its body is on the floor initially; if not, a {@link Director} puts it
 *     there, and until then the robot has no position fix
 */
public record RobotSpec(
    RobotId id,
    Pose start,
    boolean onFloor,
    Function<GlobalVarHolder, ? extends LogicThread> app) {}
