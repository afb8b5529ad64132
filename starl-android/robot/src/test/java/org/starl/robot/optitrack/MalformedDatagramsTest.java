package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.robot.realtime.RealClock;
import org.starl.sim.check.MalformedBytes;

/** Malformed datagrams to the sockets of server and feed, which go on for those who behave. */
class MalformedDatagramsTest {

  private static List<byte[]> seeds(NatNetVersion version) {
    List<byte[]> seeds = new ArrayList<>();
    List<RigidBodyState> bodies =
        List.of(
            new RigidBodyState(11, 1, 0, 3, 0, 0, 0, 1, 0.001, true),
            new RigidBodyState(12, 1, 0, 3, 0, 0, 0, 1, 0.001, true));
    seeds.add(new FullStream(version).frame(1, bodies));
    seeds.add(new FullStream(version).models());
    LittleEndianWriter out = new LittleEndianWriter();
    seeds.add(new ServerInfo("Motive", version, 10_000_000, false, 1511, 0).datagram(out));
    seeds.add(out.begin(Message.ECHO_RESPONSE).i64(1).i64(5).end());
    seeds.add(out.begin(Message.CONNECT).fixedName("Ping", 270).end());
    return seeds;
  }

  @Test
  void noDatagramBreaksTheServer() throws InterruptedException {
    Clock clock = new RealClock();
    Loopback loopback = new Loopback();
    PoseSource source =
        () ->
            new PoseSource.Snapshot(
                clock.nowNs(), List.of(new PoseSource.Body("bot0", new Pose(1, 2, 3), true, 0)));
    List<byte[]> seeds = seeds(NatNetVersion.V4_1);
    seeds.add(new LittleEndianWriter().begin(Message.ECHO_REQUEST).i64(7).end());
    seeds.add(new LittleEndianWriter().begin(Message.REQUEST_MODELS).end());
    MalformedBytes malformed = new MalformedBytes(1, seeds);
    try (NatNetServer server = loopback.serve(Loopback.server(), source, clock)) {
      for (int i = 0; i < 500; i++) {
        Loopback.send(malformed.next(), server.address());
      }
      Loopback.send(new byte[Message.MAX_BYTES], server.address());
      BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
      try (NatNetClient after =
          loopback.connect(server, NatNetSettings.unicast(Loopback.HOST), clock)) {
        after.onBodies(heard::add);
        assertThat(heard.poll(60, TimeUnit.SECONDS)).isNotNull();
      }
      assertThat(server.ignored()).isPositive();
    }
    assertThat(loopback.failures).isEmpty();
  }

  @Test
  void theLongestDatagramsAreOnlyCounted() throws InterruptedException {
    Clock clock = new RealClock();
    Loopback loopback = new Loopback();
    try (JsonFeed feed = loopback.listen(FixBounds.DEFAULT, clock)) {
      BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
      feed.onBodies(heard::add);
      List<TrackedBody> body = null;
      while (body == null) {
        long atNs = clock.nowNs();
        String line =
            "{\"robot\":\"bot0\",\"xMm\":1,\"yMm\":2,\"headingRad\":0,\"errorMm\":4,\"atNs\":";
        // The first line waits for nothing: one that waits too long gives a false clock.
        Loopback.send((line + atNs + "}").getBytes(StandardCharsets.US_ASCII), feed.address());
        Loopback.send(new byte[Message.MAX_BYTES], feed.address());
        body = heard.poll(50, TimeUnit.MILLISECONDS);
        assertThat(atNs).isLessThan(60_000_000_000L);
      }
      assertThat(feed.statistics().dropped(FeedDrop.MALFORMED)).isPositive();
    }
    assertThat(loopback.lines).hasSize(1).allMatch(line -> line.contains("65507 bytes"));
  }
}
