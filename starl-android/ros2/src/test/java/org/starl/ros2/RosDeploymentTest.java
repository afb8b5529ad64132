package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.Ros2;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RosTopic;
import org.starl.robot.file.Wheels;

/** Robots on ROS 2 in a deployment file. */
class RosDeploymentTest {

  private static Deployment read(String positions, String robot) {
    return DeploymentReader.read(
        "my.yaml",
        "app: intersection\nnetwork: {broadcasts: no}\npositions: {source: ros2"
            + positions
            + "}\nrobots:\n  bot0: {address: 127.0.0.1, platform: ros2"
            + robot
            + "}\n");
  }

  private static Wheels.Ros2 base(Deployment deployment) {
    return (Wheels.Ros2) deployment.robots().get(new RobotId("bot0")).wheels();
  }

  @Test
  void theUsualNames() {
    Deployment deployment = read("", "");
    Wheels.Ros2 base = base(deployment);
    assertThat(base.command())
        .isEqualTo(
            new RosTopic("robots.bot0.topics.command", "/bot0/cmd_vel", "Twist", true, false));
    assertThat(base.odometry().name()).isEqualTo("/bot0/odom");
    assertThat(base.odometry().isReliable()).isFalse();
    assertThat(base.contacts()).isNull();
    Positions.Ros2 positions = (Positions.Ros2) deployment.positions();
    assertThat(positions.topic().of("cart").name()).isEqualTo("/cart/pose");
    assertThat(positions.frame()).isEqualTo("map");
    assertThat(deployment.simulated()).isEmpty();
    assertThat(Ros2.isNeeded(deployment)).isTrue();
    assertThat(Ros2.of(deployment)).isInstanceOf(RosService.class);
  }

  @Test
  void otherNamesTypesAndQualities() {
    Wheels.Ros2 base =
        base(
            read(
                "",
                ", namespace: /lab/tb4, axleMm: 160, topics: {command: {type: TwistStamped,"
                    + " durability: transient_local}, odometry: {name: /odom, reliability: reliable},"
                    + " contacts: {type: LaserScan, name: scan, nearMm: 150}}"));
    assertThat(base.command().name()).isEqualTo("/lab/tb4/cmd_vel");
    assertThat(base.command().type()).isEqualTo("TwistStamped");
    assertThat(base.command().isTransientLocal()).isTrue();
    assertThat(base.odometry().name()).isEqualTo("/odom");
    assertThat(base.odometry().isReliable()).isTrue();
    assertThat(base.contacts()).isNotNull();
    assertThat(base.contacts().type()).isEqualTo("LaserScan");
    assertThat(base.nearMm()).isEqualTo(150);
    assertThat(base.axleMm()).isEqualTo(160);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          , frame: odom              | | my.yaml:3: positions.frame: 'odom': expected a frame that does not drift
          , frame: /bot0/base_link   | | my.yaml:3: positions.frame: '/bot0/base_link': expected a frame that
          , topic: /pose             | | my.yaml:3: positions.topic: '/pose': expected a topic such as /{robot}/pose
          , type: Pose               | | my.yaml:3: positions.type: 'Pose': expected one of PoseStamped
          | , namespace: bot0        | my.yaml:5: robots.bot0.namespace: 'bot0': expected a namespace such as
          | , topics: {comand: {}}   | my.yaml:5: robots.bot0.topics: 'comand': expected one of
          | , topics: {command: {reliability: RELIABLE}} | my.yaml:5: robots.bot0.topics.command.reliability: 'RELIABLE': expected one of reliable
          | , topics: {odometry: {name: 'a b'}} | my.yaml:5: robots.bot0.topics.odometry.name: 'a b': expected a topic
          | , chassis: {kind: simulated} | my.yaml:5: robots.bot0: 'chassis': expected one of
          """)
  void badInputIsOneLine(String positions, String robot, String expected) {
    assertThatThrownBy(() -> read(positions == null ? "" : positions, robot == null ? "" : robot))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(expected);
  }

  @Test
  void aSimulatedRobotHasNoRosPositions() {
    String file =
        "app: a\nworld: 127.0.0.1:4745\nnetwork: {broadcasts: no}\npositions: {source: ros2}\nrobots:\n"
            + "  bot0: {address: 127.0.0.1, chassis: {kind: simulated}}\n";
    assertThatThrownBy(() -> DeploymentReader.read("my.yaml", file))
        .hasMessageContaining(
            "robots.bot0: is simulated; expected positions.source natnet or json");
  }
}
