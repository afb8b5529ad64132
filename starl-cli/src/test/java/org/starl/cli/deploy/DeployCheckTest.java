package org.starl.cli.deploy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demos;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.cli.Cli;
import org.starl.cli.request.DeployedApp;
import org.starl.geometry.Pose;
import org.starl.launch.DeploymentFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.NatNetServerSettings;
import org.starl.robot.optitrack.NatNetVersion;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;
import org.starl.sim.SimulationPlan;

/**
 * {@code starl deploy check} and {@code starl keygen}: one line for every error, and no key shown.
 */
@Tag("realtime")
class DeployCheckTest {

  private static final String GOOD =
      """
      app: intersection
      parameters: {scenario: figure7}
      key: my.key
      positions: {source: natnet, server: 127.0.0.1}
      robots:
        bot0:
          address: 127.0.0.1:4701
          chassis: {kind: create, port: "tcp:127.0.0.1:4801"}
        bot1: {chassis: {kind: create, port: /dev/ttyUSB1}}
        bot2: {chassis: {kind: create, port: /dev/ttyUSB1}}
        bot3: {chassis: {kind: create, port: /dev/ttyUSB1}}
      """;

  /** The replacement in {@link #GOOD}, and parts of the message. */
  private static final String BAD =
      """
      app: intersection | app: crossroads | :1: | 'crossroads' | expected one of
      app: intersection | seed: 4 | has no 'app:' | starl list
      scenario: figure7 | scenario: figure8 | :1: | 'figure8' | expected drawn, figure7
      scenario: figure7 | scenaro: figure7 | :2: | 'scenaro' | did you mean scenario?
      scenario: figure7 | scenario: [] | :2: | scenario | a list
      my.key | other.key | :3: key: | other.key: no such file | starl keygen
      source: natnet | source: gps | :4: positions.source: 'gps' | natnet, json
      , server: 127.0.0.1 | , up: y | :4: positions: has no 'server:'
      server: 127.0.0.1 | server: 127.0.0.1:0 | :4: positions.server | HOST or HOST:PORT
      server: 127.0.0.1 | server: 192.168.1 | :4: positions.server: '192.168.1' | HOST or HOST:PORT
      server: 127.0.0.1 | server: 192.168.1.300 | :4: positions.server: '192.168.1.300' | HOST or HOST:PORT
      server: 127.0.0.1 | server: h, multicast: 239.255.42 | :4: positions.multicast: '239.255.42' | expected a group
      source: natnet, server: 127.0.0.1 | source: json, listen: 10.1 | :4: positions.listen: '10.1' | expected an address
      server: 127.0.0.1 | server: h, errorMm: {a: 1} | :4: positions.errorMm: a mapping: | from 0.0
      server: 127.0.0.1 | server: no.such.host.invalid | positions.server | host that has an address
      server: 127.0.0.1 | server: h, version: 9 | positions.version: '9' | expected one of 3.1
      server: 127.0.0.1 | server: h, errorMm: -1 | positions.errorMm: '-1' | from 0.0 to 1000.0
      server: 127.0.0.1 | server: 127.0.0.1, multicast: 10.0.0.1 | :4: | multicast: '10.0.0.1' | 224.0.0.0
      server: 127.0.0.1 | server: h, colour: red | :4: positions: 'colour' | expected one of
      kind: create, port: "tcp | kind: tank, port: "tcp | :8: robots.bot0.chassis.kind | create
      kind: create, port: "tcp | kind: create, baud: 9, port: "tcp | chassis.baud: '9' | 300
      tcp:127.0.0.1:4801 | tcp:127.0.0.1 | :8: robots.bot0.chassis.port | HOST:PORT
      "tcp:127.0.0.1:4801" | "127.0.0.1:4801" | :8: robots.bot0.chassis.port: '127.0.0.1:4801' | a device or tcp:HOST:PORT
      tcp:127.0.0.1:4801" | tcp:127.0.0.1:4801", simulatedAt: "host:4801" | chassis.simulatedAt: 'host:4801' | tcp:HOST:PORT
      tcp:127.0.0.1:4801" | [::1]:4801" | chassis.port: '[::1]:4801' | tcp:HOST:PORT
      bot1: | 2bot: | :9: | '2bot' | a letter
      bot1: | bot7: | :9: robots.bot7 | expected the app's robots
      bot3: {chassis: {kind: create, port: /dev/ttyUSB1}} | bot3: wheels | :11: | 'wheels' | lines
      bot3: {chassis: {kind: create, port: /dev/ttyUSB1}} | bot3: {} | robots.bot3: has no 'chassis:'
      bot1: {chassis | bot1: {address: "127.0.0.1:4701", chassis | :9: | that bot0 does not have
      bot1: {chassis: {kind: create | bot1: {chassis: {kind: simulated | 'port' | expected one of
      key: my.key | key: my.key\\nnetwork: {suspectAfterMs: 1500} | at least twice beaconEveryMs
      key: my.key | key: my.key\\nnetwork: {broadcasts: no} | bot1: has no address
      key: my.key | key: my.key\\nkey: my.key | :4: key: | once
      key: my.key | world: 127.0.0.1:4000 | has no 'key:' | broadcasts: no
      key: my.key | key: my.key\\nlimits: {watchdogMs: 60} | :4: limits.watchdogMs: '60' | more than 60
      key: my.key | key: my.key\\nlimits: {reactionMs: 2000} | :4: limits.reactionMs: '2000' | 567 mm
      key: my.key | key: my.key\\nlimits: {speedError: 1} | limits.speedError: '1' | from 0.0 to 0.9
      app: intersection | app: "intersection | is not YAML
      """;

  @TempDir private Path folder;

  static Stream<String> bad() {
    return BAD.lines();
  }

  private Path deployment(String text) throws IOException {
    Path file = folder.resolve("my.yaml");
    Files.writeString(file, text);
    return file;
  }

  private Cli check(String text, String... more) throws IOException {
    Path key = folder.resolve("my.key");
    if (!Files.exists(key)) {
      assertThat(Cli.run("keygen", key.toString()).status()).isZero();
    }
    String[] words = {"deploy", "check", deployment(text).toString()};
    return Cli.run(Stream.of(words, more).flatMap(Arrays::stream).toArray(String[]::new));
  }

  private static void assertRefused(Cli cli, String... saying) {
    assertThat(cli.err()).as("%s", cli).hasSize(1);
    assertThat(cli.err().get(0)).startsWith("starl: ").contains(saying);
    assertThat(cli.status()).isEqualTo(2);
  }

  @Test
  void aCorrectDeploymentIsSummarized() throws IOException {
    Cli cli = check(GOOD);

    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text()).contains("4 robots, sealed", "bot1: radio found by beacons, create2");
  }

  @ParameterizedTest
  @MethodSource("bad")
  void eachErrorIsOneLine(String line) throws IOException {
    String[] parts = line.split(" [|] ");
    assertThat(GOOD).contains(parts[0]);
    String text = GOOD.replace(parts[0], parts[1].replace("\\n", "\n"));

    assertRefused(check(text), Arrays.copyOfRange(parts, 2, parts.length));
  }

  @Test
  void simulatedBodiesNeedAnAddressForLinesOfJson() throws IOException {
    String simulated =
        GOOD.replace("key: my.key", "key: my.key\nworld: 127.0.0.1:4000")
            .replace("{kind: create, port: /dev/ttyUSB1}", "{kind: simulated}");
    assertThat(check(simulated).status()).isZero();

    String json = simulated.replace("{source: natnet, server: 127.0.0.1}", "{source: json}");
    assertRefused(check(json), "robots.bot1: is simulated", "expected an address, to which");
  }

  private static final String SEARCH =
      GOOD.replace("intersection", "search").replace("scenario: figure7", "rooms: 2");

  @Test
  void robotsWithoutTheSensorThatTheAppNeedsAreRefused() throws IOException {
    Cli none = check(SEARCH);
    assertThat(none.status()).isEqualTo(2);
    assertThat(none.err())
        .hasSize(4)
        .first(InstanceOfAssertFactories.STRING)
        .contains(":6: robots.bot0.objects: ''", "search needs an object sensor", "600 mm");

    String bumpers = SEARCH.replace("{chassis", "{objects: positions, chassis");
    assertRefused(
        check(bumpers.replace("  bot0:\n", "  bot0:\n    objects: bumper\n")),
        "robots.bot0.objects: 'bumper'",
        "expected positions");
    assertRefused(
        Cli.run("deploy", "run", deployment(SEARCH).toString(), "--robot", "bot0"),
        "robots.bot0.objects: ''");
  }

  @Test
  void robotsThatSenseTaggedObjectsMaySearch() throws IOException {
    String tagged =
        SEARCH
            .replace("{chassis", "{objects: positions, chassis")
            .replace("  bot0:\n", "  bot0:\n    objects: positions\n");
    assertThat(check(tagged).status()).isZero();
  }

  @Test
  void theAppAllowsForTheDeploymentsReactionTime() throws IOException {
    check(GOOD);
    Deployment deployment =
        DeploymentFile.read(
            deployment(GOOD.replace("key: my.key", "key: my.key\nlimits: {reactionMs: 150}"))
                .toString());
    SimulationPlan plan =
        DeployedApp.of(deployment, new Demos(List.of(new IntersectionDemo()))).plan();
    assertThat(plan.settings().motionParameters(0).reactionMs()).isEqualTo(150);
    assertThat(plan.header().settings()).as("so that a merge knows it").containsKey("reaction");
  }

  @Test
  void aWorldWithoutBodiesIsRefused() throws IOException {
    check(GOOD);

    assertRefused(Cli.run("deploy", "world", deployment(GOOD).toString()), "no robot is simulated");
  }

  @Test
  void aRobotThatCannotBeginEndsItsWorldWithTheReason() throws IOException {
    try (DatagramSocket taken = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      String simulated =
          GOOD.replace("key: my.key", "key: my.key\nworld: 127.0.0.1:" + freeTcpPort())
              .replace("server: 127.0.0.1", "server: 127.0.0.1:" + freeUdpPort())
              .replace("4701", Integer.toString(taken.getLocalPort()))
              .replace("{kind: create, port: \"tcp:127.0.0.1:4801\"}", "{kind: simulated}");
      check(simulated);

      Cli cli =
          Cli.run(
              "deploy", "world", deployment(simulated).toString(), "--folder", folder.toString());

      assertThat(cli.status()).as("%s", cli).isEqualTo(1);
      assertThat(cli.err()).hasSize(1);
      assertThat(cli.err().get(0)).contains("bot0", "radio at 127.0.0.1:" + taken.getLocalPort());
    }
  }

  private static int freeTcpPort() throws IOException {
    try (ServerSocket any = new ServerSocket(0)) {
      return any.getLocalPort();
    }
  }

  private static int freeUdpPort() throws IOException {
    try (DatagramSocket any = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      return any.getLocalPort();
    }
  }

  @Test
  void aMissingDeviceIsAProblemOnItsRobotsMachine() throws IOException {
    assertRefused(check(GOOD, "--robot", "bot1"), "robots.bot1.chassis.port", "no such device");
    String elsewhere = GOOD.replace("server: 127.0.0.1}", "server: 127.0.0.1, interface: nosuch0}");
    assertThat(check(elsewhere).status()).isZero();
    assertRefused(
        check(elsewhere, "--robot", "bot0"), ":4: positions.interface: 'nosuch0'", "one of [");
    assertRefused(check(GOOD, "--robot", "bot9"), "has no robot 'bot9'", "bot0, bot1");
  }

  @Test
  void serversThatDoNotAnswerAreProblems() throws IOException {
    Cli cli = check(GOOD.replace("4801", "1"), "--probe");

    assertThat(cli.status()).isEqualTo(2);
    assertThat(cli.err()).as("%s", cli).hasSize(2);
    assertThat(cli.err().get(0)).contains("bot0.chassis.port", "127.0.0.1:1");
    assertThat(cli.err().get(1))
        .contains(
            ":4: positions.server: '127.0.0.1:1510': no positions of [bot0, bot1, bot2, bot3]",
            "does not answer; look at this address");
  }

  @Test
  void camerasThatAnswerAreAskedForEachRobot() throws IOException {
    RealClock clock = RealClock.ofDate();
    List<PoseSource.Body> bodies =
        Stream.of("bot0", "bot1", "bot3")
            .map(name -> new PoseSource.Body(name, new Pose(0, 0, 0), false, 0))
            .toList();
    NatNetServerSettings settings =
        new NatNetServerSettings(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            null,
            new NatNetVersion(4, 1),
            Axes.DEFAULT,
            100);
    try (ServerSocket create = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        NatNetServer cameras =
            NatNetServer.open(
                settings,
                () -> new PoseSource.Snapshot(clock.nowNs(), bodies),
                clock,
                failure -> {})) {
      String text =
          GOOD.replace("4801", "" + create.getLocalPort())
              .replace("server: 127.0.0.1", "server: 127.0.0.1:" + cameras.address().getPort());
      assertRefused(
          check(text, "--probe"), "no positions of [bot2]: frames come, but without its place");
    }
  }

  @Test
  void aKeyIsNotReplacedNorReadIfOthersMayReadIt() throws IOException {
    check(GOOD);
    Path key = folder.resolve("my.key");
    byte[] before = Files.readAllBytes(key);

    assertRefused(Cli.run("keygen", key.toString()), "exists; expected a new file");
    assertThat(Files.readAllBytes(key)).isEqualTo(before);

    Files.setPosixFilePermissions(key, PosixFilePermissions.fromString("rw-r-----"));
    assertRefused(check(GOOD), ":3: key:", "rw-r-----", "only its owner");
  }

  @Test
  void aWrongKeyIsNotShown() throws IOException {
    check(GOOD);
    Path key = folder.resolve("my.key");
    String secret = "secret".repeat(11).substring(0, 64);
    Files.writeString(key, secret);

    Cli cli = check(GOOD);

    assertRefused(cli, "is not a key", "64 hexadecimal digits");
    assertThat(cli.toString()).doesNotContain("secretsecret");
  }
}
