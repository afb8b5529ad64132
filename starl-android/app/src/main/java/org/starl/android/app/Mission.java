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

  /** Prefix of a chassis port over Bluetooth; the adapter's name or address follows. */
  static final String BLUETOOTH = "bluetooth:";

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
    Mission mission = new Mission(deployment, robot, PhoneApps.program(deployment), keys, linesKey);
    if (mission.bluetooth() == null && mission.tcp() == null) {
      throw BadInput.at(
          deployment.file(),
          robot.line(),
          "robots."
              + robot.id()
              + ": chassis: expected, on a phone, kind create and port "
              + BLUETOOTH
              + "NAME or tcp:HOST:PORT");
    }
    return mission;
  }

  /** Name or address of the Create's Bluetooth adapter; null if it has none. */
  @Nullable String bluetooth() {
    if (!(robot.wheels() instanceof Wheels.Create create)
        || !(create.port() instanceof Wheels.Device device)) {
      return null;
    }
    String path = device.path();
    boolean hasName = path.startsWith(BLUETOOTH) && path.length() > BLUETOOTH.length();
    return hasName ? path.substring(BLUETOOTH.length()) : null;
  }

  /** The TCP address of the Create's serial line; null if it has none. */
  Wheels.@Nullable Tcp tcp() {
    return robot.wheels() instanceof Wheels.Create create && create.port() instanceof Wheels.Tcp tcp
        ? tcp
        : null;
  }
}
