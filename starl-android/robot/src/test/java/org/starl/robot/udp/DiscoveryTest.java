package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.StableStorage;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Session;
import org.starl.session.Start;

/** Robots on the loopback interface find, prove and refuse each other. */
@Tag("realtime")
class DiscoveryTest {

  private static final RobotId ME = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");
  private static final Participants BOTH = Participants.of(List.of(ME, OTHER));
  private static final DeploymentKey KEY = key(1);
  private static final Duration MINUTE = Duration.ofMinutes(1);

  private static DeploymentKey key(int fill) {
    byte[] secret = new byte[DeploymentKey.BYTES];
    Arrays.fill(secret, (byte) fill);
    return new DeploymentKey(secret);
  }

  /** One start of a robot: its radio with discovery, and what they report. */
  private static final class Station implements AutoCloseable, Discovery.Listener {
    private final RobotId self;
    private final RealStrand strand = new RealStrand("bot", new RealClock(), e -> {});
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
    private final CompletableFuture<Boolean> flushed = new CompletableFuture<>();
    private final OpenSessions sessions = new OpenSessions();
    private final LoneRobot.PromptStable stable;
    private final UdpRadio radio;
    private @Nullable Discovery discovery;

    /** Set before there are beacons. */
    private boolean isBroken;

    Station(RobotId self) throws Exception {
      this(self, null, 0);
    }

    /** Another start, with the storage and the port of an earlier one. */
    Station(RobotId self, LoneRobot.@Nullable PromptStable kept, int port) throws Exception {
      this.self = self;
      stable =
          kept == null
              ? new LoneRobot.PromptStable(strand)
              : new LoneRobot.PromptStable(strand, kept);
      InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
      radio = UdpRadio.open(self, strand, any, e -> told.add("failed"));
      radio.onDrop(told::add);
    }

    Station discover(Map<RobotId, InetSocketAddress> known) {
      return discover(known, 1, 60_000);
    }

    Station discover(Map<RobotId, InetSocketAddress> known, int boot, long suspectAfterMs) {
      return discover(known, boot, suspectAfterMs, PeerKeys.shared(KEY, self, BOTH));
    }

    Station discover(
        Map<RobotId, InetSocketAddress> known, int boot, long suspectAfterMs, PeerKeys keys) {
      Discovery started =
          new Discovery(
              radio,
              self,
              BOTH,
              new TreeMap<>(known),
              keys,
              sessions,
              strand,
              stable,
              new Discovery.Settings(20, suspectAfterMs, 0),
              new RealClock(),
              this);
      discovery = started;
      CompletableFuture<Boolean> begun = new CompletableFuture<>();
      strand.post(() -> {
        started.begin(boot);
        begun.complete(true);
      });
      begun.join();
      return this;
    }

    void announceTo(Station station) {
      if (discovery != null) {
        discovery.announce(radio.address().getAddress(), station.radio.address());
      }
    }

    @Override
    public void appeared(RobotId robot, InetSocketAddress address) {
      fail();
      told.add(robot + " at " + address.getPort());
    }

    @Override
    public void suspected(RobotId robot, @Nullable Long lastHeardNs) {
      fail();
      told.add(robot + " suspected");
    }

    @Override
    public void refused(RobotId robot, InetSocketAddress address, boolean isOtherStorage) {
      told.add(robot + " refused" + (isOtherStorage ? ": other storage" : ""));
    }

    @Override
    public void unknown(List<RobotId> knownTo) {
      told.add("known to " + knownTo);
    }

    @Override
    public void disowned(String why) {
      told.add("disowned: " + why);
    }

    /** Promises something: {@code flushed} when it counts. */
    void promise() {
      StableStorage storage = Objects.requireNonNull(discovery).storage();
      strand.post(() -> storage.put("promise", new byte[1], () -> flushed.complete(true)));
    }

    private void fail() {
      if (isBroken) {
        throw new IllegalStateException("a bug");
      }
    }

    String next() throws InterruptedException {
      return String.valueOf(told.poll(60, TimeUnit.SECONDS));
    }

    /** The next report that contains this. */
    String next(String part) throws InterruptedException {
      String line = next();
      while (!line.contains(part) && !line.equals("null")) {
        line = next();
      }
      return line;
    }

    /** The session with a robot, as soon as it is open. */
    Session session(RobotId robot) throws Exception {
      return sessionAfter(null, robot);
    }

    /** The session that replaces {@code former}, as soon as it is open. */
    Session sessionAfter(@Nullable Session former, RobotId robot) throws Exception {
      long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
      while (System.nanoTime() < endNs) {
        CompletableFuture<@Nullable Session> now = new CompletableFuture<>();
        strand.post(() -> now.complete(sessions.with(robot)));
        Session session = now.get(60, TimeUnit.SECONDS);
        if (session != null && session != former) {
          return session;
        }
      }
      throw new AssertionError(self + " has no session with " + robot);
    }

    @Override
    public void close() {
      if (discovery != null) {
        discovery.close();
      }
      radio.close();
      strand.close();
    }
  }

  private static boolean opens(Session from, Session to) {
    byte[] datagram = new byte[40];
    byte[] sealed = new byte[40 + Session.BYTES];
    from.seal(datagram, 8, 40, sealed);
    return to.isOf(sealed, sealed.length) && to.open(sealed, 8, sealed.length, new byte[80]);
  }

  @Test
  void aRobotOfUnknownAddressIsFoundAndBothOpenOneSession() throws Exception {
    try (Station me = new Station(ME);
        Station other = new Station(OTHER)) {
      me.discover(Map.of());
      other.discover(Map.of(ME, me.radio.address()));

      assertThat(me.next()).isEqualTo("bot1 at " + other.radio.address().getPort());
      assertThat(opens(me.session(OTHER), other.session(ME))).isTrue();
      assertThat(opens(other.session(ME), me.session(OTHER))).isTrue();
    }
  }

  /** The new key is listed first, and the robot still has the old one. */
  @Test
  void whileAKeyIsReplacedBothKeysAreTried(@TempDir Path folder) throws Exception {
    List<RobotKey> secrets = new ArrayList<>();
    List<PublicRobotKey> published = new ArrayList<>();
    for (String name : List.of("mine", "old", "new")) {
      published.add(RobotKey.generate(folder.resolve(name)));
      secrets.add(RobotKey.read(folder.resolve(name)));
    }
    Map<RobotId, List<PublicRobotKey>> listed =
        Map.of(ME, List.of(published.get(0)), OTHER, List.of(published.get(2), published.get(1)));
    try (Station me = new Station(ME);
        Station other = new Station(OTHER)) {
      me.discover(
          Map.of(OTHER, other.radio.address()),
          1,
          60_000,
          PeerKeys.separate(secrets.get(0), listed));
      other.discover(Map.of(), 1, 60_000, PeerKeys.separate(secrets.get(1), listed));

      assertThat(opens(me.session(OTHER), other.session(ME))).isTrue();
    }
  }

  @Test
  void aLaterStartOfARobotGetsANewSession() throws Exception {
    try (Station me = new Station(ME).discover(Map.of())) {
      Session first;
      Session firstOfMine;
      LoneRobot.PromptStable kept;
      try (Station other = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        first = other.session(ME);
        kept = other.stable;
        firstOfMine = me.session(OTHER);
        assertThat(opens(first, firstOfMine)).isTrue();
      }
      try (Station again =
          new Station(OTHER, kept, 0).discover(Map.of(ME, me.radio.address()), 2, 60_000)) {
        Session second = again.session(ME);
        Session secondOfMine = me.sessionAfter(firstOfMine, OTHER);

        assertThat(opens(second, secondOfMine)).isTrue();
        assertThat(opens(first, secondOfMine)).isFalse();
      }
    }
  }

  @Test
  void aRobotThatHasLostItsStorageIsRefusedAndTold() throws Exception {
    try (Station me = new Station(ME).discover(Map.of())) {
      try (Station other = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        other.session(ME);
        me.session(OTHER);
      }
      try (Station lost = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        assertThat(me.next("refused")).isEqualTo("bot1 refused: other storage");
        assertThat(lost.next("disowned"))
            .isEqualTo(
                "disowned: bot0 knows another storage of bot1: the promises in it are lost. Bring"
                    + " it back, or start all robots with empty storage");
      }
    }
  }

  @Test
  void aNewStoragePromisesNothingBeforeTheOthersKnowIt() throws Exception {
    LoneRobot.PromptStable kept;
    try (Station me = new Station(ME).discover(Map.of(), 1, 10)) {
      me.promise();
      assertThat(me.next("suspected")).isEqualTo("bot1 suspected");
      assertThat(me.next()).isEqualTo("known to []");
      assertThat(me.flushed).isNotDone();
      try (Station other = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        other.promise();
        assertThat(me.flushed).succeedsWithin(MINUTE);
        assertThat(other.flushed).succeedsWithin(MINUTE);
      }
      kept = me.stable;
    }
    // Once known, it does not wait.
    try (Station again = new Station(ME, kept, 0).discover(Map.of(), 2, 60_000)) {
      again.promise();
      assertThat(again.flushed).succeedsWithin(MINUTE);
    }
  }

  @Test
  void aLostStorageNeverPromises() throws Exception {
    try (Station me = new Station(ME).discover(Map.of())) {
      try (Station other = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        other.promise();
        assertThat(other.flushed).succeedsWithin(MINUTE);
      }
      try (Station lost = new Station(OTHER).discover(Map.of(ME, me.radio.address()))) {
        lost.promise();
        lost.next("disowned");
        me.next("refused");
        assertThat(lost.flushed).isNotDone();
      }
    }
  }

  @Test
  void anEarlierStartIsRefusedAndToldEvenAfterARestart() throws Exception {
    LoneRobot.PromptStable mine;
    LoneRobot.PromptStable ofOther;
    try (Station me = new Station(ME).discover(Map.of());
        Station other = new Station(OTHER).discover(Map.of(ME, me.radio.address()), 7, 60_000)) {
      other.session(ME);
      me.session(OTHER);
      mine = me.stable;
      ofOther = other.stable;
    }
    try (Station restarted = new Station(ME, mine, 0).discover(Map.of(), 2, 60_000);
        Station old =
            new Station(OTHER, ofOther, 0)
                .discover(Map.of(ME, restarted.radio.address()), 6, 60_000)) {
      assertThat(restarted.next("refused")).isEqualTo("bot1 refused");
      assertThat(old.next("disowned"))
          .isEqualTo(
              "disowned: bot0 knows a later start of bot1: another machine runs it, or this storage"
                  + " is an old copy");
    }
  }

  @Test
  void twoMachinesOfOneNameBothStop() throws Exception {
    try (Station one = new Station(ME).discover(Map.of());
        Station two = new Station(ME).discover(Map.of())) {
      one.announceTo(two);

      assertThat(one.next("disowned"))
          .contains("another machine runs bot0 too, at ")
          .contains(":" + two.radio.address().getPort());
      assertThat(two.next("disowned")).contains("another machine runs bot0 too, at ");
    }
  }

  @Test
  void beaconsWithoutTheKeyOrFromAnotherAddressAreDroppedAndReported() throws Exception {
    try (Station me = new Station(ME);
        DatagramSocket stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      me.discover(Map.of());
      SigningKey key = new SigningKey(KEY.pairKey(ME, OTHER));
      byte[] changed = beacon(OTHER, stranger.getLocalPort()).write(key);
      changed[20]++;
      List<byte[]> bytes = new ArrayList<>();
      bytes.add(
          beacon(OTHER, stranger.getLocalPort()).write(new SigningKey(key(2).pairKey(ME, OTHER))));
      bytes.add(changed);
      bytes.add(beacon(OTHER, 1234).write(key));
      for (byte[] datagram : bytes) {
        stranger.send(new DatagramPacket(datagram, datagram.length, me.radio.address()));
      }

      assertThat(me.next()).contains("signed with a key that this deployment does not list");
      assertThat(me.next()).contains("that the robot it names has not signed");
      assertThat(me.next()).contains("names another source address");
    }
  }

  private static Beacon beacon(RobotId from, int port) {
    Start start = new Start(1, 1, new Nonce(1, 1));
    InetAddress here = InetAddress.getLoopbackAddress();
    return new Beacon(from, start, 1, here, port, ME, Nonce.NONE, Answer.ACCEPTED);
  }

  @Test
  void anExceptionOnTheRadiosThreadIsReported() throws Exception {
    try (Station me = new Station(ME);
        Station other = new Station(OTHER)) {
      me.isBroken = true;
      me.discover(Map.of(OTHER, other.radio.address()));
      other.discover(Map.of(ME, me.radio.address()));

      assertThat(me.next("failed")).isEqualTo("failed");
      assertThat(me.radio.isClosed()).isTrue();
    }
  }

  @Test
  void anExceptionOnTheBeaconsThreadIsReported() throws Exception {
    try (Station me = new Station(ME)) {
      me.isBroken = true;
      me.discover(Map.of(), 1, 1);

      assertThat(me.next()).isEqualTo("failed");
    }
  }
}
