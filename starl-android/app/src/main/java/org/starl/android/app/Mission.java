package org.starl.android.app;

import org.jspecify.annotations.Nullable;
import org.starl.apps.RobotProgram;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.udp.PeerKeys;

/**
 * This phone's task: one robot of a deployment, checked without network or hardware. Immutable.
 *
 * @param program of the deployment's robots
 * @param keys seal the datagrams to and from other robots; null if the deployment has no keys
 * @param linesKey of the JSON feed's lines; null for none
 */
record Mission(
    Deployment deployment,
    RobotEntry robot,
    RobotProgram program,
    @Nullable PeerKeys keys,
    @Nullable DeploymentKey linesKey) {

  /**
   * @throws BadInput if a phone cannot run this robot of this deployment
   */
  static Mission of(
      Deployment deployment,
      String robotName,
      @Nullable PeerKeys keys,
      @Nullable DeploymentKey linesKey) {
    RobotEntry robot = deployment.robot(robotName);
    String secret = deployment.secretOf(robot);
    if (secret != null && keys == null) {
      throw deployment.error("key", secret, "this key to be loaded onto the phone too");
    }
    if (deployment.positions() instanceof Positions.JsonFeed json
        && json.key() != null
        && linesKey == null) {
      throw deployment.error(
          "positions", json.key(), "the deployment's own key: a phone has one key file");
    }
    RobotProgram program = PhoneApps.program(deployment);
    if (!(robot.wheels() instanceof Wheels.Create create && SerialPorts.canOpen(create.port()))) {
      throw BadInput.at(
          deployment.file(),
          robot.line(),
          "robots."
              + robot.id()
              + ": chassis: expected, on a phone, kind create and port "
              + SerialPorts.BLUETOOTH
              + "NAME or tcp:HOST:PORT");
    }
    return new Mission(deployment, robot, program, keys, linesKey);
  }

  /** The port of the Create. */
  Wheels.Port port() {
    return ((Wheels.Create) robot.wheels()).port();
  }
}
