package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.DeploymentKey;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.robot.udp.PeerKeys;

class MissionTest {

  private static final String SEALED =
      """
      app: intersection
      parameters: {scenario: figure7}
      key: my.key
      network: {broadcasts: no}
      positions: {source: natnet, server: 10.0.0.1}
      robots:
        bot0:
          address: 10.0.0.10
          chassis: {kind: create, port: "bluetooth:RooTooth"}
        bot1:
          address: 10.0.0.11
          chassis: {kind: create, port: "tcp:10.0.0.21:23"}
        bot2:
          address: 10.0.0.12
          chassis: {kind: create, port: /dev/ttyUSB0}
      """;

  private static Mission mission(String text, String robot, DeploymentKey key) {
    Deployment deployment = DeploymentReader.read("my.yaml", text);
    PeerKeys keys =
        key == null ? null : PeerKeys.shared(key, new RobotId("bot0"), deployment.participants());
    return Mission.of(deployment, robot, keys, key);
  }

  private static DeploymentKey key() {
    byte[] secret = new byte[DeploymentKey.BYTES];
    Arrays.fill(secret, (byte) 0x5a);
    return new DeploymentKey(secret);
  }

  private static void isRefused(String text, String robot, DeploymentKey key, String why) {
    assertThatThrownBy(() -> mission(text, robot, key))
        .isInstanceOf(BadInput.class)
        .hasMessage(why);
  }

  @Test
  void aCreateIsReachedOverBluetoothOrTcp() {
    assertThat(mission(SEALED, "bot0", key()).port()).hasToString("bluetooth:RooTooth");
    assertThat(mission(SEALED, "bot1", key()).port()).hasToString("tcp:10.0.0.21:23");
  }

  @Test
  void aSerialDeviceIsRefusedOnAPhone() {
    isRefused(
        SEALED,
        "bot2",
        key(),
        "my.yaml:13: robots.bot2: chassis: expected, on a phone, kind create and port bluetooth:NAME or"
            + " tcp:HOST:PORT");
  }

  @Test
  void aDeploymentWithAKeyNeedsItsKey() {
    isRefused(
        SEALED,
        "bot0",
        null,
        "my.yaml:3: key: 'my.key': expected this key to be loaded onto the phone too");
  }

  @Test
  void aScenarioThatNeedsTheSimulatorIsRefused() {
    isRefused(
        SEALED.replace("figure7", "open"),
        "bot0",
        key(),
        "my.yaml:2: scenario='open': expected drawn or figure7 on robots");
    isRefused(
        SEALED.replace("figure7}", "figure7, arrivals: 20/min}"),
        "bot0",
        key(),
        "my.yaml:2: arrivals='20/min': expected none on robots without the simulator");
  }

  @Test
  void anUnknownAppAParameterOrATooLargeTeamIsRefusedInOneLine() {
    isRefused(
        SEALED.replace("app: intersection", "app: crossroads"),
        "bot0",
        key(),
        "my.yaml:1: app: 'crossroads': expected one of [doors, fleet, hello, intersection, lightpaint,"
            + " maze, race, search], this phone's apps");
    isRefused(
        SEALED.replace("figure7}", "figure7, floorWidth: 7m}"),
        "bot0",
        key(),
        "my.yaml:2: floorWidth: '7m': expected one of [arrivals, car, debris, files, scenario] for"
            + " intersection on a phone");
    isRefused(
        SEALED.replace("app: intersection", "app: race").replace("scenario: figure7", "drawn: 0"),
        "bot0",
        key(),
        "my.yaml:2: drawn: '0': expected a whole number from 1 to 100");
  }

  @Test
  void everyAppOfThePaperRunsOnAPhone() {
    String parameters = "parameters: {scenario: figure7}\n";
    for (String app : PhoneApps.names()) {
      String text = SEALED.replace(parameters, "").replace("app: intersection", "app: " + app);
      assertThat(mission(text, "bot0", key()).program()).as(app).isNotNull();
    }
  }

  @Test
  void theKeyIsNeverShown() {
    assertThat(mission(SEALED, "bot0", key()).toString())
        .doesNotContain("5a5a")
        .doesNotContain("90, 90");
  }
}
