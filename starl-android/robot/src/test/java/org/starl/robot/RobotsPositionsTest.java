package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;

class RobotsPositionsTest {

  private static RobotEntry robot(String name, String rigidBody) {
    return new RobotEntry(
        new RobotId(name), 1, null, new Wheels.Simulated(), rigidBody, List.of(), null);
  }

  @Test
  void robotsHaveTheFixesOfTheirRigidBodies() {
    Fix red = new Fix(new Pose(1, 2, 3), 4, 5, 6);
    Fix box = new Fix(new Pose(7, 8, 0), 4, 5, 6);
    assertThat(
            DeployedRobot.positions(
                Map.of("red", red, "box", box),
                List.of(robot("bot0", "red"), robot("bot1", "blue"))))
        .isEqualTo(Map.of(new RobotId("bot0"), red));
  }
}
