package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.platform.DeploymentKey;
import org.starl.robot.realtime.RealClock;

/** Lines with a key: of the sender, of other senders, changed, and recorded. */
class JsonFeedKeyTest {

  private static final long MS = 1_000_000;

  /** In November 2026, by a clock of the date. */
  private static final long DATE_NS = 1_795_000_000_000_000_000L - RealClock.DATE_ORIGIN_UNIX_NS;

  private static final DeploymentKey KEY = key(1);

  private final List<String> lines = new ArrayList<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> lines.add(line), "test");
  private JsonProtocol protocol = new JsonProtocol(FixBounds.DEFAULT, KEY, tally);

  private static DeploymentKey key(int first) {
    byte[] secret = new byte[DeploymentKey.BYTES];
    secret[0] = (byte) first;
    return new DeploymentKey(secret);
  }

  private static byte[] line(double xMm, long atNs) {
    return JsonServer.line(new PoseSource.Body("bot0", new Pose(xMm, 0, 0), true, 1), atNs)
        .getBytes(StandardCharsets.US_ASCII);
  }

  private static byte[] sealed(double xMm, long atNs) {
    return new JsonSeal(KEY).seal(line(xMm, atNs));
  }

  private @Nullable TrackedBody receive(byte[] datagram, long nowNs) {
    return protocol.received(datagram, datagram.length, nowNs);
  }

  /** Sends each 10 ms for 600 ms and returns all; the last ones are fixes. */
  private List<byte[]> run(long beganNs) {
    List<byte[]> sent = new ArrayList<>();
    TrackedBody last = null;
    for (long atNs = beganNs; atNs <= beganNs + 600 * MS; atNs += 10 * MS) {
      byte[] datagram = sealed(0, atNs);
      sent.add(datagram);
      last = receive(datagram, atNs + MS);
    }
    assertThat(last).isNotNull();
    return sent;
  }

  private long dropped(FeedDrop why) {
    return tally.statistics().dropped(why);
  }

  @Test
  void linesOfTheSenderAreUsedAndNoneCountsTwice() {
    List<byte[]> sent = run(DATE_NS);
    long nowNs = DATE_NS + 610 * MS;
    for (byte[] datagram : sent) {
      assertThat(receive(datagram, nowNs)).isNull();
    }
    assertThat(dropped(FeedDrop.REPLAYED)).isEqualTo(sent.size());
    assertThat(receive(sealed(0, nowNs), nowNs + MS)).isNotNull();
  }

  @Test
  void timesOfLinesAreInNanosecondsSince1970() {
    assertThat(new String(line(0, DATE_NS), StandardCharsets.US_ASCII))
        .endsWith("\"atNs\":1795000000000000000}");
    assertThat(RealClock.ofDate().nowNs() + RealClock.DATE_ORIGIN_UNIX_NS)
        .isGreaterThan(1_795_000_000_000_000_000L - 200L * 24 * 3600 * 1000 * MS);
  }

  @Test
  void aChangedLineIsForgedWhereverItIsChanged() {
    byte[] genuine = sealed(0, DATE_NS);
    for (int i = 0; i < genuine.length; i++) {
      byte[] changed = genuine.clone();
      changed[i] ^= 1;
      receive(changed, DATE_NS);
    }
    for (int length = 0; length < genuine.length; length++) {
      receive(Arrays.copyOf(genuine, length), DATE_NS);
    }
    receive(line(0, DATE_NS), DATE_NS);
    receive(new JsonSeal(key(2)).seal(line(0, DATE_NS)), DATE_NS);
    receive(new byte[Message.MAX_BYTES + 1], DATE_NS);
    assertThat(dropped(FeedDrop.FORGED)).isEqualTo(2L * genuine.length + 3);
    assertThat(lines).hasSize(1);
  }

  @Test
  void recordingsOfAnotherRunCountNeitherNowNorForARobotThatStartsLater() {
    List<byte[]> sent = run(DATE_NS);
    long laterNs = DATE_NS + 600 * MS + JsonProtocol.MOST_DATE_ERROR_NS + 2 * MS;
    run(laterNs);
    sent.forEach(datagram -> assertThat(receive(datagram, laterNs + 610 * MS)).isNull());
    assertThat(dropped(FeedDrop.REPLAYED)).isEqualTo(sent.size());

    protocol = new JsonProtocol(FixBounds.DEFAULT, KEY, tally);
    sent.forEach(datagram -> assertThat(receive(datagram, laterNs)).isNull());
    assertThat(dropped(FeedDrop.REPLAYED)).isEqualTo(2L * sent.size());
    assertThat(dropped(FeedDrop.EARLY)).isEqualTo(50);
  }

  @Test
  void aSenderThatStartsAgainIsUsed() {
    run(DATE_NS);
    run(DATE_NS + 700 * MS);
    assertThat(dropped(FeedDrop.REPLAYED)).isZero();
  }

  @Test
  void aSenderWhoseDateIsWrongIsToldOnce() {
    for (int i = 0; i < 100; i++) {
      long nowNs = DATE_NS + 10 * i * MS;
      assertThat(receive(sealed(0, nowNs - 6000 * MS), nowNs)).isNull();
    }
    assertThat(lines).hasSize(1).allMatch(line -> line.contains("5 s off this machine's date"));
  }

  @Test
  @Tag("realtime")
  void theServersLinesReachAFeedWithItsKeyAndNoOther() throws Exception {
    RealClock clock = RealClock.ofDate();
    Loopback loopback = new Loopback();
    InetSocketAddress any = new InetSocketAddress(Loopback.HOST, 0);
    PoseSource source =
        () ->
            new PoseSource.Snapshot(
                clock.nowNs(), List.of(new PoseSource.Body("bot0", new Pose(1, 2, 3), true, 0)));
    BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
    BlockingQueue<List<TrackedBody>> misheard = new LinkedBlockingQueue<>();
    try (JsonFeed feed = JsonFeed.open(settings(any, KEY), clock, loopback.log);
        JsonFeed other = JsonFeed.open(settings(any, key(2)), clock, loopback.log);
        JsonServer server =
            JsonServer.open(
                any,
                List.of(feed.address(), other.address()),
                KEY,
                source,
                clock,
                100,
                loopback.failures::add)) {
      feed.onBodies(heard::add);
      other.onBodies(misheard::add);
      List<TrackedBody> bodies = heard.poll(60, TimeUnit.SECONDS);
      assertThat(bodies).hasSize(1);
      assertThat(bodies.get(0).fix().pose()).isEqualTo(new Pose(1, 2, 3));
      assertThat(misheard).isEmpty();
      assertThat(other.statistics().dropped(FeedDrop.FORGED)).isPositive();
      assertThat(server.unsent()).isZero();
      assertThat(loopback.failures).isEmpty();
    }
  }

  private static JsonFeedSettings settings(InetSocketAddress at, DeploymentKey key) {
    return new JsonFeedSettings(at, null, key, FixBounds.DEFAULT);
  }
}
