package org.starl.robot;

import java.io.IOException;
import java.util.Collection;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import org.starl.input.BadInput;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.optitrack.FixBounds;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.trace.TraceEvent;

/** ROS 2: a service of a module of its own, because few need its libraries. */
public interface Ros2 {

  /** Starts a process of this program with another main class. */
  @FunctionalInterface
  interface Starter {
    Process start(String main, List<String> args) throws IOException;
  }

  /** Receives a robot's events, to show them as topics. One thread at a time. */
  interface Display extends Consumer<TraceEvent>, AutoCloseable {
    @Override
    void close();
  }

  /**
   * The wheels of a base.
   *
   * @param guards starts the guard, which stops the wheels when this process ends or is frozen
   */
  Wheelbase.Source wheels(RobotEntry robot, Wheels.Ros2 base, Limits limits, Starter guards);

  /**
   * The poses of {@code bodies}, by their names.
   *
   * @param bounds with the deployment's errors and limits
   * @throws IOException if there is no ROS 2 on this machine; one line for people
   */
  PoseFeed poses(
      Positions.Ros2 positions,
      Collection<String> bodies,
      FixBounds bounds,
      Clock clock,
      LogSink log)
      throws IOException;

  /** Topics of a robot's events and variables, under its namespace. */
  Display display(RobotEntry robot, Wheels.Ros2 base, Positions positions) throws IOException;

  /** Whether the deployment needs it. */
  static boolean isNeeded(Deployment deployment) {
    return deployment.positions() instanceof Positions.Ros2
        || deployment.robots().values().stream()
            .anyMatch(robot -> robot.wheels() instanceof Wheels.Ros2);
  }

  /**
   * The service.
   *
   * @throws BadInput if its module is not on the class path
   */
  static Ros2 of(Deployment deployment) {
    for (Ros2 service : ServiceLoader.load(Ros2.class)) {
      return service;
    }
    throw new BadInput(
        deployment.file()
            + ": ros2: its module is not on the class path; expected './starl deploy', which adds it, or"
            + " starl-android-ros2 among the libraries");
  }
}
