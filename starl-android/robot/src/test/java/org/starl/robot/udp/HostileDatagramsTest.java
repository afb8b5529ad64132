package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.comms.Comms;
import org.starl.comms.DropReason;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Strand;
import org.starl.random.Rng;
import org.starl.robot.contract.RealGround;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Session;
import org.starl.session.Start;
import org.starl.sim.check.MalformedBytes;

/**
 * A robot with radio, discovery and key, among senders without the key that record, change, cut, forge and
 * forward datagrams and beacons: it accepts none of theirs, each of its friend's, and stores nothing.
 *
 * <p>{@code -Dstarl.fuzz=1000000} sends so many, {@code -Dstarl.fuzz.seed=7} others.
 */
@Tag("realtime")
class HostileDatagramsTest {

  private static final int COUNT = Integer.getInteger("starl.fuzz", 100_000);
  private static final long SEED = Long.getLong("starl.fuzz.seed", 1);
  private static final int OVER_THE_SOCKET = 5_000;
  private static final int BATCH = 50;
  private static final int RECORDED = 60;
  private static final long HEAP_BYTES = 1 << 20;

  private static final RobotId ME = new RobotId("bot0");
  private static final RobotId FRIEND = new RobotId("bot1");
  private static final Participants BOTH = Participants.of(List.of(ME, FRIEND));
  private static final DeploymentKey KEY = key(2);
  private static final Start FRIENDS_START = new Start(5, 5, new Nonce(5, 5));
  private static final Start LATER = new Start(5, 6, new Nonce(6, 6));
  private static final InetAddress HERE = InetAddress.getLoopbackAddress();

  private final Rng rng = new Rng(SEED);
  private final OpenSessions friendsSessions = new OpenSessions();
  private final LoneRobot friend = new LoneRobot(FRIEND, BOTH, friendsSessions);
  private final SigningKey friendsKey = new SigningKey(KEY.pairKey(FRIEND, ME));
  private Start victimsStart = FRIENDS_START;
  private final List<byte[]> recorded = new ArrayList<>();
  private final List<byte[]> beacons = new ArrayList<>();
  private final AtomicInteger appearances = new AtomicInteger();

  /** A datagram and whether it seems to come from the friend. */
  private record Hostile(byte[] bytes, boolean isFromFriend) {}

  private static DeploymentKey key(int first) {
    byte[] secret = new byte[DeploymentKey.BYTES];
    secret[0] = (byte) first;
    return new DeploymentKey(secret);
  }

  /** The robot that is attacked. */
  private final class Victim implements AutoCloseable, Discovery.Listener {
    private final UdpRadio radio;
    private final Discovery discovery;
    private final OpenSessions sessions = new OpenSessions();
    private final Comms comms;
    private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();

    Victim(Strand strand) throws IOException {
      InetSocketAddress any = new InetSocketAddress(HERE, 0);
      radio =
          UdpRadio.open(
              ME,
              strand,
              any,
              failure -> {
                throw new AssertionError(failure);
              });
      comms = new Comms(LoneRobot.platform(ME, BOTH, radio, strand, sessions), 1);
      comms.open(LoneRobot.TALK, (from, message) -> heard.add(from + ": " + message));
      discovery =
          new Discovery(
              radio,
              ME,
              BOTH,
              new TreeMap<>(),
              PeerKeys.shared(KEY, ME, BOTH),
              sessions,
              strand,
              new LoneRobot.PromptStable(strand),
              new Discovery.Settings(3_600_000, 3_600_000, 0),
              () -> 1,
              this);
      discovery.begin(1);
    }

    @Override
    public void appeared(RobotId robot, InetSocketAddress address) {
      appearances.incrementAndGet();
    }

    @Override
    public void suspected(RobotId robot, @Nullable Long lastHeardNs) {
      throw new AssertionError(robot + " is suspected");
    }

    @Override
    public void refused(RobotId robot, InetSocketAddress address, boolean isOtherStorage) {
      throw new AssertionError(robot + " is refused");
    }

    @Override
    public void unknown(List<RobotId> knownTo) {}

    @Override
    public void disowned(String why) {
      throw new AssertionError(why);
    }

    @Override
    public void close() {
      discovery.close();
      radio.close();
    }
  }

  /**
   * The friend's messages, of both kinds, and its beacons from its address. Before, it must get the
   * victim's nonce: the answer to a first beacon has it.
   */
  private void record(DatagramSocket friends, Victim victim) throws IOException {
    int port = friends.getLocalPort();
    send(friends, beacon(FRIEND, FRIENDS_START, 1, port, ME, Nonce.NONE).write(friendsKey), victim);
    byte[] answer = new byte[UdpRadio.MAX_BYTES];
    DatagramPacket packet = new DatagramPacket(answer, answer.length);
    friends.receive(packet);
    Beacon beacon = Beacon.readOrNull(answer, packet.getLength());
    victimsStart = Objects.requireNonNull(beacon).start();
    friendsSessions.open(
        ME, new Session(friendsKey.pair(), FRIEND, FRIENDS_START, ME, victimsStart));
    for (int i = 0; i < RECORDED; i++) {
      if (i % 2 == 0) {
        friend.talk.send(ME, "message " + i);
      } else {
        friend.talk.sendReliably(ME, "message " + i);
      }
    }
    recorded.addAll(friend.sent);
    for (int i = 2; i <= RECORDED; i++) {
      beacons.add(
          beacon(FRIEND, FRIENDS_START, i, port, ME, victimsStart.nonce()).write(friendsKey));
    }
  }

  private static Beacon beacon(
      RobotId from, Start start, int count, int port, @Nullable RobotId to, Nonce echo) {
    return new Beacon(from, start, count, HERE, port, to, echo, Answer.ACCEPTED);
  }

  /** One that nobody who has the key has sent, or that was heard before. */
  private Hostile next(MalformedBytes malformed, List<byte[]> forged) {
    boolean isBeacon = rng.nextBoolean(0.4);
    byte[] honest = any(isBeacon ? beacons : recorded);
    return switch (rng.nextInt(6)) {
      case 0 -> new Hostile(honest, true);
      case 1 -> new Hostile(honest, false);
      case 2 -> new Hostile(changed(honest), true);
      case 3 -> new Hostile(Arrays.copyOf(honest, rng.nextInt(honest.length)), true);
      case 4 -> new Hostile(any(forged), rng.nextBoolean(0.5));
      default -> new Hostile(malformed.next(), rng.nextBoolean(0.8));
    };
  }

  private byte[] any(List<byte[]> all) {
    return all.get(rng.nextInt(all.size()));
  }

  private byte[] changed(byte[] honest) {
    byte[] changed = honest.clone();
    changed[rng.nextInt(changed.length)] ^= (byte) (1 + rng.nextInt(255));
    return changed;
  }

  /** Sound in all but the key; too long; of strangers; and of the robot itself. */
  private List<byte[]> forged(int friendPort) {
    List<byte[]> forged = new ArrayList<>();
    for (DeploymentKey other : Arrays.asList(key(1), null)) {
      LoneRobot forger = new LoneRobot(FRIEND, BOTH, other);
      forger.talk.send(ME, "forged");
      forger.talk.sendReliably(ME, "forged");
      forger.talk.broadcast("forged");
      forged.addAll(forger.sent);
      SigningKey signing = other == null ? null : new SigningKey(other.pairKey(FRIEND, ME));
      forged.add(beacon(FRIEND, LATER, 1, friendPort, ME, victimsStart.nonce()).write(signing));
    }
    forged.add(
        beacon(FRIEND, LATER, 1, friendPort == 1 ? 2 : 1, ME, victimsStart.nonce())
            .write(friendsKey));
    forged.add(beacon(FRIEND, LATER, 1, friendPort, ME, new Nonce(8, 8)).write(friendsKey));
    forged.add(beacon(FRIEND, LATER, 1, friendPort, null, Nonce.NONE).write(null));
    forged.add(beacon(ME, victimsStart, 1, friendPort, null, Nonce.NONE).write(null));
    forged.add(beacon(new RobotId("spy"), LATER, 1, friendPort, null, Nonce.NONE).write(null));
    forged.add(new byte[UdpRadio.MAX_BYTES + 1]);
    return forged;
  }

  @Test
  void hostileDatagramsAreDroppedAndNotStored() throws Exception {
    LoneRobot.PromptStrand strand = new LoneRobot.PromptStrand();
    try (Victim victim = new Victim(strand);
        DatagramSocket friendsSocket = new DatagramSocket(0, HERE);
        DatagramSocket strangersSocket = new DatagramSocket(0, HERE)) {
      InetSocketAddress friendly = address(friendsSocket);
      InetSocketAddress strange = address(strangersSocket);
      record(friendsSocket, victim);
      beacons.forEach(beacon -> judge(victim, strand, beacon, friendly));
      recorded.forEach(message -> judge(victim, strand, message, friendly));
      assertThat(victim.heard).hasSize(RECORDED);
      assertThat(appearances).hasValue(1);
      victim.heard.clear();

      long droppedBefore = droppedBelow(victim);
      long received = victim.radio.statistics().received();
      long sent = victim.radio.statistics().sent();
      List<byte[]> forged = forged(friendly.getPort());
      MalformedBytes malformed = new MalformedBytes(SEED, samples());
      attack(victim, strand, malformed, forged, friendly, strange, COUNT / 10);
      long usedBefore = usedBytes();
      attack(victim, strand, malformed, forged, friendly, strange, COUNT - COUNT / 10);
      long usedAfter = usedBytes();

      assertThat(victim.heard).as("seed %d", SEED).isEmpty();
      assertThat(appearances).as("seed %d", SEED).hasValue(1);
      UdpStatistics statistics = victim.radio.statistics();
      assertThat(statistics.sent()).as("answers").isEqualTo(sent);
      assertThat(LoneRobot.dropped(victim.comms)).isEqualTo(statistics.received() - received);
      long below = droppedBelow(victim) - droppedBefore;
      assertThat(below + statistics.received() - received).isEqualTo(COUNT);
      assertThat(victim.comms.dropped(DropReason.FORGED)).isGreaterThan(COUNT / 10);
      assertThat(victim.comms.dropped(DropReason.REPLAYED)).isGreaterThan(COUNT / 20);
      assertThat(statistics.dropped().keySet())
          .contains(
              UdpDrop.FOREIGN,
              UdpDrop.OVERSIZE,
              UdpDrop.FORGED_BEACON,
              UdpDrop.UNKNOWN_KEY_BEACON,
              UdpDrop.PASSED_ON_BEACON,
              UdpDrop.STRANGE_BEACON,
              UdpDrop.OLD_BEACON,
              UdpDrop.OWN_BEACON);
      assertThat(usedAfter - usedBefore).as("bytes more in use").isLessThan(HEAP_BYTES);
      friend.talk.send(ME, "still there?");
      judge(victim, strand, last(friend.sent), friendly);
      assertThat(victim.heard).containsExactly("bot1: still there?");
      report(victim, usedAfter - usedBefore);
    }
  }

  private static long droppedBelow(Victim victim) {
    return victim.radio.statistics().dropped().values().stream().mapToLong(Long::longValue).sum();
  }

  private void attack(
      Victim victim,
      LoneRobot.PromptStrand strand,
      MalformedBytes malformed,
      List<byte[]> forged,
      InetSocketAddress friendly,
      InetSocketAddress strange,
      int count) {
    for (int i = 0; i < count; i++) {
      Hostile hostile = next(malformed, forged);
      judge(victim, strand, hostile.bytes(), hostile.isFromFriend() ? friendly : strange);
    }
  }

  @Test
  void hostileDatagramsOverTheLoopbackInterfaceAreDropped() throws Exception {
    try (RealGround ground = new RealGround("victim");
        Victim victim = new Victim(ground.strand());
        DatagramSocket friends = new DatagramSocket(0, HERE);
        DatagramSocket strangers = new DatagramSocket(0, HERE)) {
      record(friends, victim);
      List<byte[]> forged = forged(friends.getLocalPort());
      MalformedBytes malformed = new MalformedBytes(SEED, samples());
      for (byte[] beacon : beacons) {
        send(friends, beacon, victim);
      }
      awaitSession(ground.strand(), victim.sessions);
      for (byte[] datagram : recorded) {
        send(friends, datagram, victim);
      }
      for (int i = 0; i < RECORDED; i++) {
        assertThat(victim.heard.poll(60, TimeUnit.SECONDS)).isEqualTo("bot1: message " + i);
      }
      for (int i = 0; i < OVER_THE_SOCKET; i++) {
        Hostile hostile = next(malformed, forged);
        send(hostile.isFromFriend() ? friends : strangers, hostile.bytes(), victim);
        if (i % BATCH == 0) {
          // No more than the socket's buffer holds is under way.
          friend.talk.send(ME, "after " + i);
          send(friends, last(friend.sent), victim);
          assertThat(victim.heard.poll(60, TimeUnit.SECONDS)).isEqualTo("bot1: after " + i);
        }
      }
      assertThat(victim.heard).isEmpty();
      assertThat(appearances).hasValue(1);
      assertThat(ground.errors()).isEmpty();
    }
  }

  private static void awaitSession(Strand strand, OpenSessions sessions) throws Exception {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    boolean isOpen = false;
    while (!isOpen && System.nanoTime() < endNs) {
      CompletableFuture<Boolean> now = new CompletableFuture<>();
      strand.post(() -> now.complete(sessions.with(FRIEND) != null));
      isOpen = now.get(60, TimeUnit.SECONDS);
    }
    assertThat(isOpen).as("a session with the friend").isTrue();
  }

  private List<byte[]> samples() {
    List<byte[]> samples = new ArrayList<>(recorded);
    samples.addAll(beacons);
    return samples;
  }

  private static byte[] last(List<byte[]> all) {
    return all.get(all.size() - 1);
  }

  private static InetSocketAddress address(DatagramSocket socket) {
    return new InetSocketAddress(HERE, socket.getLocalPort());
  }

  private static void judge(
      Victim victim, LoneRobot.PromptStrand strand, byte[] datagram, InetSocketAddress from) {
    // As the radio receives them: into a longer buffer, and cut off there.
    byte[] buffer = Arrays.copyOf(datagram, UdpRadio.MAX_BYTES + 1);
    victim.radio.accept(new DatagramPacket(buffer, Math.min(datagram.length, buffer.length), from));
    strand.run();
  }

  private static void send(DatagramSocket from, byte[] datagram, Victim to) throws IOException {
    from.send(new DatagramPacket(datagram, datagram.length, to.radio.address()));
  }

  /** What is in use once nothing more can be given back. */
  private static long usedBytes() {
    Runtime runtime = Runtime.getRuntime();
    long used = Long.MAX_VALUE;
    for (int i = 0; i < 4; i++) {
      System.gc();
      used = Math.min(used, runtime.totalMemory() - runtime.freeMemory());
    }
    return used;
  }

  private static void report(Victim victim, long moreBytes) {
    if (Integer.getInteger("starl.fuzz") != null) {
      StringBuilder counts = new StringBuilder();
      for (DropReason reason : DropReason.values()) {
        counts.append(reason).append(' ').append(victim.comms.dropped(reason)).append(", ");
      }
      System.out.println(
          COUNT
              + " datagrams: "
              + victim.radio.statistics()
              + ", "
              + counts
              + moreBytes
              + " bytes");
    }
  }
}
