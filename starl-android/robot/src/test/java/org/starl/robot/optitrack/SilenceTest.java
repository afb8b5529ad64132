package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.robot.contract.RealGround;

/** Each set-up that gives a robot no positions is told, with what to look at; the clock is the test's. */
@Tag("realtime")
class SilenceTest {

  private static final long MS = 1_000_000;

  private final AtomicLong nowNs = new AtomicLong(1000 * MS);
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
  private final Loopback loopback = new Loopback();
  private final RealGround ground = new RealGround("bot0");

  @AfterEach
  void closeTheGround() {
    ground.close();
  }

  private void log(String line) {
    if (line.startsWith("no position")) {
      lines.add(line);
    }
  }

  private NatNetClient client(NatNetSettings settings) throws Exception {
    return NatNetClient.open(settings, nowNs::get, (timeNs, level, tag, line) -> log(line));
  }

  /** The line that comes between two and three seconds after the robot follows its body. */
  private String told(PoseFeed feed) throws InterruptedException {
    feed.positioning(ground.strand(), "bot0");
    String line = null;
    for (int i = 0; line == null && i < 300; i++) {
      nowNs.addAndGet(10 * MS);
      line = lines.poll(i < 200 ? 1 : 100, TimeUnit.MILLISECONDS);
      assertThat(line == null || i >= 200).as(line).isTrue();
    }
    assertThat(line).isNotNull().startsWith("no position of bot0 for 2 s: ");
    return line;
  }

  private PoseSource still(String name) {
    return () ->
        new PoseSource.Snapshot(
            nowNs.get(), List.of(new PoseSource.Body(name, new Pose(1, 2, 0), true, 0)));
  }

  @Test
  void nothingAtTheCamerasAddress() throws Exception {
    try (DatagramSocket mute = new DatagramSocket(new InetSocketAddress(Loopback.HOST, 0))) {
      InetSocketAddress at = new InetSocketAddress(Loopback.HOST, mute.getLocalPort());
      NatNetSettings settings = new NatNetSettings(at, null, null, Axes.DEFAULT, FixBounds.DEFAULT);
      try (NatNetClient client = client(settings)) {
        assertThat(told(client))
            .contains(PoseFeed.text(at) + " does not answer; look at this address");
      }
    }
  }

  @Test
  void connectedButNoFrames() throws Exception {
    InetSocketAddress group = Loopback.freeGroup();
    NatNetServerSettings serving =
        Loopback.server(group, NatNetServerSettings.VERSIONS.get(0), Axes.DEFAULT, 100);
    try (NatNetServer server = loopback.serve(serving, still("bot0"), nowNs::get)) {
      NatNetSettings settings =
          new NatNetSettings(server.address(), null, null, Axes.DEFAULT, FixBounds.DEFAULT);
      try (NatNetClient client = client(settings)) {
        assertThat(told(client)).contains(" answers, but no usable frames come ", "(unicast)");
      }
    }
  }

  @Test
  void framesWithoutTheRobot() throws Exception {
    try (NatNetServer server = loopback.serve(Loopback.server(), still("bot7"), nowNs::get)) {
      NatNetSettings settings =
          new NatNetSettings(server.address(), null, null, Axes.DEFAULT, FixBounds.DEFAULT);
      try (NatNetClient client = client(settings)) {
        assertThat(told(client)).contains("frames come, but without its place");
      }
    }
  }

  @Test
  void noLine() throws Exception {
    try (JsonFeed feed = jsonFeed()) {
      assertThat(told(feed)).contains("no line has come to " + PoseFeed.text(feed.address()));
    }
  }

  @Test
  void linesOfAnotherRobot() throws Exception {
    try (JsonFeed feed = jsonFeed();
        DatagramSocket sender = new DatagramSocket()) {
      byte[] line =
          "{\"robot\":\"bot7\",\"xMm\":1,\"yMm\":2,\"headingRad\":1,\"errorMm\":4,\"atNs\":8}"
              .getBytes(StandardCharsets.UTF_8);
      sender.send(new DatagramPacket(line, line.length, feed.address()));
      while (feed.statistics().received() == 0) {
        Thread.onSpinWait();
      }
      assertThat(told(feed)).contains("1 messages have come, but not its place", "names");
    }
  }

  private JsonFeed jsonFeed() throws Exception {
    JsonFeedSettings settings =
        new JsonFeedSettings(
            new InetSocketAddress(Loopback.HOST, 0), null, null, FixBounds.DEFAULT);
    return JsonFeed.open(settings, nowNs::get, (timeNs, level, tag, line) -> log(line));
  }

  @Test
  void theInterfaceIsThatTowardsTheServer() throws Exception {
    InetSocketAddress server = new InetSocketAddress(Loopback.HOST, 1510);
    InetAddress elsewhere = InetAddress.getByName("192.0.2.1");
    InetAddress alsoHere = InetAddress.getByName("127.0.0.1");
    assertThat(NatNetClient.towards(server, null).isLoopbackAddress()).isTrue();
    assertThat(NatNetClient.towards(server, elsewhere).isLoopbackAddress()).isTrue();
    assertThat(NatNetClient.towards(server, alsoHere)).isEqualTo(alsoHere);
  }
}
