package org.starl.sim;

import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * One robot of a simulation.
 *
 * @param start pose of its body when it is put on the floor
 * @param onFloor whether its body is on the floor initially; if not, a {@link Director} puts it
 *     there, and until then the robot has no position fix
 * @param origin of the coordinates of its positioning system, in the world; (0, 0) for most robots.
 *     Robots with different origins do not understand each other's positions
 */
public record RobotSpec(
    RobotId id,
    Pose start,
    boolean onFloor,
    Function<GlobalVarHolder, ? extends RobotApp> app,
    Point origin) {

  /** A robot whose positioning system has the world's origin. */
  public RobotSpec(
      RobotId id, Pose start, boolean onFloor, Function<GlobalVarHolder, ? extends RobotApp> app) {
    this(id, start, onFloor, app, new Point(0, 0));
  }
}
