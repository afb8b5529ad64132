package org.starl.ros2;

import java.io.IOException;
import java.util.Collection;
import org.starl.body.WheelCommand;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.robot.Ros2;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.RosTopic;
import org.starl.robot.file.Wheels;
import org.starl.robot.optitrack.FixBounds;
import org.starl.robot.optitrack.PoseFeed;

/** The service that {@link Ros2} finds. */
public final class RosService implements Ros2 {

  @Override
  public Wheelbase.Source wheels(
      RobotEntry robot, Wheels.Ros2 base, Limits limits, Starter guards) {
    String name = robot.id().name();
    return (strand, clock, log, onFailure) -> {
      RosNode node = RosNode.open("starl_" + name, clock, log);
      try {
        RosTopic command = base.command();
        RosNode.Output output = node.publish(command, true);
        RosType type = RosType.of(command.type());
        SpeedLink.Source links =
            () ->
                new GuardLink(
                    name,
                    guards.start(
                        GuardMain.class.getName(),
                        GuardMain.args(command, WheelGuard.validMs(limits.reactionMs()))));
        RosBase wheels =
            new RosBase(
                name,
                base.odometry().name(),
                base.axleMm(),
                limits,
                links,
                () -> output.publish(Messages.twist(WheelCommand.STOP, type, RosBase.unixNs())),
                strand,
                clock,
                log,
                onFailure,
                node);
        node.subscribe(
            base.odometry(),
            true,
            message -> {
              Messages.Odometry odometry = Messages.odometry(message);
              if (odometry != null) {
                wheels.odometry(odometry);
              }
            });
        RosTopic contacts = base.contacts();
        if (contacts != null) {
          RosType kind = RosType.of(contacts.type());
          node.subscribe(
              contacts,
              true,
              message -> wheels.contacts(Messages.contacts(message, kind, base.nearMm())));
        }
        wheels.start();
        return wheels;
      } catch (IOException | RuntimeException e) {
        node.close();
        throw e;
      }
    };
  }

  @Override
  public PoseFeed poses(
      Positions.Ros2 positions,
      Collection<String> bodies,
      FixBounds bounds,
      Clock clock,
      LogSink log)
      throws IOException {
    return RosPoses.open(positions, bodies, bounds, clock, log);
  }

  @Override
  public Display display(RobotEntry robot, Wheels.Ros2 base, Positions positions)
      throws IOException {
    return RosDisplay.open(robot, base, positions);
  }
}
