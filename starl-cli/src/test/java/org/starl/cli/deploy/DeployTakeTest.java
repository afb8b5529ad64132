package org.starl.cli.deploy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.geometry.Fix;
import org.starl.launch.DeploymentFile;
import org.starl.robot.PoseFeeds;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.robot.optitrack.TrackedBody;
import org.starl.robot.realtime.RealClock;

/** {@code starl deploy take}: a session is recorded, and robots get its poses again. */
@Tag("realtime")
class DeployTakeTest {

  @TempDir private Path folder;

  private Path deployment(String positions) throws IOException {
    return Files.writeString(
        folder.resolve("d.yaml"),
        """
        app: intersection
        parameters: {scenario: figure7}
        key: my.key
        positions: %s
        robots:
          bot0:
            address: 127.0.0.1:4701
            chassis: {kind: create, port: /dev/ttyUSB0}
          bot1: {chassis: {kind: create, port: /dev/ttyUSB1}}
          bot2: {chassis: {kind: create, port: /dev/ttyUSB1}}
          bot3: {chassis: {kind: create, port: /dev/ttyUSB1}}
        """
            .formatted(positions));
  }

  private Path take() {
    Path take = folder.resolve("take.csv");
    Cli recorded =
        Cli.run(
            "record",
            "intersection",
            "--set",
            "scenario=figure7",
            "--for",
            "2s",
            "--seed",
            "1",
            "--csv",
            "take",
            "--out",
            take.toString());
    assertThat(take).as("%s", recorded).exists();
    return take;
  }

  @Test
  void robotsGetTheSessionsPosesAgain() throws Exception {
    Path take = take();
    int port;
    try (DatagramSocket free =
        new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))) {
      port = free.getLocalPort();
    }
    Path file = deployment("{source: natnet, server: \"127.0.0.1:" + port + "\"}");
    CompletableFuture<Cli> playing =
        CompletableFuture.supplyAsync(
            () -> Cli.run("deploy", "take", file.toString(), take.toString(), "--hold", "2s"));
    RealClock clock = new RealClock();
    try (PoseFeed feed =
        PoseFeeds.open(
            DeploymentFile.read(file.toString()),
            null,
            InetAddress.getLoopbackAddress(),
            clock,
            (timeNs, level, tag, line) -> {})) {
      BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
      feed.onBodies(heard::add);
      Fix first = null;
      while (first == null) {
        List<TrackedBody> bodies = heard.poll(60, TimeUnit.SECONDS);
        assertThat(bodies).as("nothing was heard").isNotNull();
        first =
            bodies.stream()
                .filter(each -> each.name().equals("bot1"))
                .findFirst()
                .orElseThrow()
                .fix();
      }
      String row = Files.readAllLines(take).get(7);
      double xM = Double.parseDouble(row.split(",", -1)[2 + 7 + 4]);
      assertThat(first.pose().xMm()).isCloseTo(1000 * xM, within(0.1));
    }
    Cli played = playing.get(60, TimeUnit.SECONDS);
    assertThat(played.status()).as("%s", played).isZero();
    assertThat(played.out()).contains("bot1: tracked in 201 of 201 frames", "the take has ended");
  }

  @Test
  void whatCannotBePlayedIsRefused() throws IOException {
    Path take = take();
    Path file = deployment("{source: natnet, server: 127.0.0.1}");
    Cli.run("deploy", "take", file.toString(), file.toString())
        .assertRefused("d.yaml:1: begins with");
    Cli.run("deploy", "take", file.toString(), take.toString(), "--hold", "3")
        .assertRefused("--hold: '3'");
    Path others =
        Files.writeString(
            folder.resolve("others.csv"), Files.readString(take).replace("bot", "car"));
    Cli.run("deploy", "take", file.toString(), others.toString())
        .assertRefused("tracks no robot", "[car0, car1, car2, car3]");
  }
}
