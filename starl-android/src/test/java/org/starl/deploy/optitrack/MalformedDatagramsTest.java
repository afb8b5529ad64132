package org.starl.deploy.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.starl.deploy.realtime.RealClock;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.random.Rng;

/**
 * Random, cut, mutated and spliced datagrams against every parser: none throws, none brings a fix of
 * something that no robot on a floor can be, none makes a parser keep more than the datagram holds.
 *
 * <p>{@code -Dstarl.fuzz=1000000} sets how many, {@code -Dstarl.fuzz.seed=7} replays.
 */
class MalformedDatagramsTest {

  private static final int TRIES = Integer.getInteger("starl.fuzz", 20_000);
  private static final long SEED = Long.getLong("starl.fuzz.seed", 1);
  private static final int LEAST_MODEL_BYTES = 9;

  private final Rng rng = new Rng(SEED);
  private final Map<String, Integer> outcomes = new TreeMap<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> checkLine(line), "fuzz");
  private final NatNetProtocol client =
      new NatNetProtocol(
          NatNetSettings.unicast(Loopback.HOST), tally, datagram -> {}, this::checkBodies);
  private long nowNs = 1_000_000_000;

  private static void checkLine(String line) {
    assertThat(line).hasSizeLessThan(1000).doesNotContain("\n", "\r", "\u001b");
  }

  private void checkBodies(List<TrackedBody> bodies) {
    for (TrackedBody body : bodies) {
      if (body.fix() != null) {
        Pose pose = body.fix().pose();
        assertThat(Math.abs(pose.xMm())).isLessThanOrEqualTo(1e7);
        assertThat(Math.abs(pose.yMm())).isLessThanOrEqualTo(1e7);
        assertThat(Math.abs(pose.headingRad())).isLessThanOrEqualTo(StrictMath.PI);
        assertThat(body.fix().timeNs()).isLessThanOrEqualTo(nowNs);
        assertThat(body.fix().errorMm()).isBetween(5.0, 1e5);
        assertThat(body.fix().errorRad()).isBetween(0.02, StrictMath.PI);
        count("fixes of bodies");
      }
    }
  }

  private void count(String outcome) {
    outcomes.merge(outcome, 1, Integer::sum);
  }

  private List<byte[]> seeds(NatNetVersion version) {
    List<byte[]> seeds = new ArrayList<>();
    List<RigidBodyState> bodies =
        List.of(
            new RigidBodyState(11, 1, 0, 3, 0, 0, 0, 1, 0.001, true),
            new RigidBodyState(12, 1, 0, 3, 0, 0, 0, 1, 0.001, true));
    seeds.add(new FullStream(version).frame(1, bodies));
    seeds.add(new FullStream(version).models());
    LittleEndianWriter out = new LittleEndianWriter();
    seeds.add(new ServerInfo("Motive", version, 10_000_000, false, 1511, 0).datagram(out));
    seeds.add(out.begin(Message.ECHO_RESPONSE).i64(nowNs).i64(5).end());
    seeds.add(out.begin(Message.CONNECT).fixedName("Ping", 270).end());
    return seeds;
  }

  private byte[] mangled(List<byte[]> seeds) {
    byte[] from = seeds.get(rng.nextInt(seeds.size()));
    int kind = rng.nextInt(5);
    int length = kind == 1 ? rng.nextInt(from.length + 1) : from.length + rng.nextInt(9);
    byte[] bytes = kind == 0 ? new byte[rng.nextInt(300)] : Arrays.copyOf(from, length);
    if (kind == 0) {
      fill(bytes, 0);
    } else if (kind == 2 && length > 0) {
      fill(bytes, rng.nextInt(length));
    } else if (kind == 3) {
      splice(bytes, seeds.get(rng.nextInt(seeds.size())));
    }
    for (int i = rng.nextInt(6); i > 0 && bytes.length > 0; i--) {
      mutate(bytes);
    }
    if (bytes.length >= 4 && !rng.nextBoolean(0.1)) {
      // A header in accord with the rest, so that what is behind it is read.
      bytes[2] = (byte) (bytes.length - 4);
      bytes[3] = (byte) ((bytes.length - 4) >> 8);
    }
    return bytes;
  }

  private void fill(byte[] bytes, int from) {
    for (int i = from; i < bytes.length; i++) {
      bytes[i] = (byte) rng.nextInt(256);
    }
    if (from == 0 && bytes.length > 1 && rng.nextBoolean(0.8)) {
      bytes[0] = (byte) rng.nextInt(15);
      bytes[1] = 0;
    }
  }

  private void splice(byte[] bytes, byte[] other) {
    int to = rng.nextInt(bytes.length);
    int from = rng.nextInt(other.length);
    System.arraycopy(other, from, bytes, to, Math.min(bytes.length - to, other.length - from));
  }

  /** A byte, or a count or size of 32 bits, becomes what hurts. */
  private void mutate(byte[] bytes) {
    int at = rng.nextInt(bytes.length);
    int[] evil = {0, 1, -1, 0x7f, 0x80, 0xff, Integer.MAX_VALUE, Integer.MIN_VALUE, 65_536};
    int value = rng.nextBoolean(0.3) ? rng.nextInt(Integer.MAX_VALUE) : evil[rng.nextInt(9)];
    int width = rng.nextBoolean(0.5) ? 1 : Math.min(4, bytes.length - at);
    for (int i = 0; i < width; i++) {
      bytes[at + i] = (byte) (value >> 8 * i);
    }
  }

  @Test
  void noDatagramHurtsTheClient() {
    Map<NatNetVersion, List<byte[]>> seeds = new TreeMap<>();
    FullStream.VERSIONS.forEach(version -> seeds.put(version, seeds(version)));
    for (int i = 0; i < TRIES; i++) {
      NatNetVersion version = FullStream.VERSIONS.get(rng.nextInt(5));
      byte[] datagram = mangled(seeds.get(version));
      nowNs += rng.nextLong(0, 5_000_000);
      try {
        parse(datagram, version);
        client.tick(nowNs);
        client.received(datagram, datagram.length, nowNs);
      } catch (RuntimeException | AssertionError e) {
        throw replay(i, datagram, e);
      }
    }
    report("client");
    assertThat(outcomes.get("frames refused")).isGreaterThan(TRIES / 20);
    assertThat(outcomes.get("frames read")).isGreaterThan(TRIES / 100);
    assertThat(outcomes.get("fixes of bodies")).isPositive();
  }

  /** Each parser by itself, for each sees more than the client lets through. */
  private void parse(byte[] datagram, NatNetVersion version) {
    MocapFrame frame = FrameParser.parse(Message.payload(datagram, datagram.length), version);
    count(frame == null ? "frames refused" : "frames read");
    if (frame != null) {
      assertThat(frame.bodies().size() * RigidBodyState.BYTES).isLessThan(datagram.length);
    }
    Models models = Models.parse(Message.payload(datagram, datagram.length), version);
    count(models == null ? "models refused" : "models read");
    if (models != null) {
      assertThat(models.ids().size() * LEAST_MODEL_BYTES).isLessThanOrEqualTo(datagram.length);
    }
    ServerInfo info = ServerInfo.parse(Message.payload(datagram, datagram.length));
    count(info == null ? "servers refused" : "servers read");
  }

  @Test
  void noLineHurtsTheFeed() {
    String line =
        "{\"robot\":\"bot0\",\"xMm\":12,\"yMm\":-35.5e0,\"headingRad\":1.5,\"errorMm\":4,"
            + "\"errorRad\":0.1,\"atNs\":";
    JsonProtocol feed = new JsonProtocol(FixBounds.DEFAULT, tally);
    String evil = "{}[]\",:\\0123456789.eE+-truefalsn \n\u00e9\u0000";
    for (int i = 0; i < TRIES; i++) {
      nowNs += rng.nextLong(0, 5_000_000);
      byte[] bytes = (line + nowNs + "}").getBytes(StandardCharsets.UTF_8);
      for (int j = rng.nextInt(4); j > 0; j--) {
        bytes[rng.nextInt(bytes.length)] = (byte) evil.charAt(rng.nextInt(evil.length()));
      }
      int length = rng.nextBoolean(0.8) ? bytes.length : rng.nextInt(bytes.length + 1);
      try {
        TrackedBody body = feed.received(bytes, length, nowNs);
        count(body == null ? "lines refused" : "lines read");
        if (body != null) {
          checkBodies(List.of(body));
        }
      } catch (RuntimeException | AssertionError e) {
        throw replay(i, bytes, e);
      }
    }
    report("feed");
    assertThat(outcomes.get("lines read")).isPositive();
    assertThat(outcomes.get("lines refused")).isGreaterThan(TRIES / 10);
  }

  @Test
  void noDatagramHurtsTheServer() throws InterruptedException {
    Clock clock = new RealClock();
    Loopback loopback = new Loopback();
    PoseSource source =
        () ->
            new PoseSource.Snapshot(
                clock.nowNs(), List.of(new PoseSource.Body("bot0", new Pose(1, 2, 3), true, 0)));
    List<byte[]> seeds = seeds(NatNetVersion.V4_1);
    seeds.add(new LittleEndianWriter().begin(Message.ECHO_REQUEST).i64(7).end());
    seeds.add(new LittleEndianWriter().begin(Message.REQUEST_MODELS).end());
    try (NatNetServer server =
        loopback.serve(NatNetServerSettings.unicast(Loopback.HOST), source, clock)) {
      for (int i = 0; i < 500; i++) {
        Loopback.send(mangled(seeds), server.address());
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
    try (JsonFeed feed = loopback.listen(JsonFeedSettings.at(Loopback.HOST), clock)) {
      BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
      feed.onBodies(heard::add);
      List<TrackedBody> body = null;
      while (body == null) {
        long atNs = clock.nowNs();
        Loopback.send(new byte[Message.MAX_BYTES], feed.address());
        String line =
            "{\"robot\":\"bot0\",\"xMm\":1,\"yMm\":2,\"headingRad\":0,\"errorMm\":4,\"atNs\":";
        Loopback.send((line + atNs + "}").getBytes(StandardCharsets.US_ASCII), feed.address());
        body = heard.poll(50, TimeUnit.MILLISECONDS);
        assertThat(atNs).isLessThan(60_000_000_000L);
      }
      assertThat(feed.statistics().dropped(FeedDrop.MALFORMED)).isPositive();
    }
    assertThat(loopback.lines).hasSize(1).allMatch(line -> line.contains("65507 bytes"));
  }

  private void report(String what) {
    if (Integer.getInteger("starl.fuzz") != null) {
      System.out.println(what + ", " + TRIES + " datagrams: " + outcomes);
      System.out.println(tally.statistics());
    }
  }

  private static AssertionError replay(int number, byte[] datagram, Throwable cause) {
    StringBuilder hex = new StringBuilder();
    for (byte each : datagram) {
      hex.append(String.format("%02x", each));
    }
    return new AssertionError(
        "datagram " + number + " of -Dstarl.fuzz.seed=" + SEED + ": " + hex, cause);
  }
}
