package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.random.Rng;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;

@Tag("realtime")
class DiscoveryTest {

  private static final RobotId ME = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");
  private static final Participants BOTH = Participants.of(List.of(ME, OTHER));
  private static final DeploymentKey KEY = new DeploymentKey(new byte[DeploymentKey.BYTES]);
  private static final long S = 1_000_000_000;

  private static DeploymentKey otherKey() {
    byte[] secret = new byte[DeploymentKey.BYTES];
    secret[0] = 1;
    return new DeploymentKey(secret);
  }

  /** A radio with discovery, and what it tells. */
  private static final class Station implements AutoCloseable, Discovery.Listener {
    private final RealStrand strand = new RealStrand("bot", new RealClock(), e -> {});
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
    private final UdpRadio radio;
    private @Nullable Discovery discovery;

    /** Set before there are beacons. */
    private boolean isBroken;

    Station(RobotId self) throws Exception {
      InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
      radio = UdpRadio.open(self, strand, any, e -> told.add("failed"));
      radio.onDrop(told::add);
    }

    void discover(RobotId self, Map<RobotId, InetSocketAddress> known) {
      discover(self, known, 60_000);
    }

    void discover(RobotId self, Map<RobotId, InetSocketAddress> known, long suspectAfterMs) {
      Discovery.Settings settings = new Discovery.Settings(20, suspectAfterMs, 0);
      discovery =
          Discovery.open(
              radio, self, BOTH, new TreeMap<>(known), KEY, settings, 1, new RealClock(), this);
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

    private void fail() {
      if (isBroken) {
        throw new IllegalStateException("a bug");
      }
    }

    String next() throws InterruptedException {
      return String.valueOf(told.poll(60, TimeUnit.SECONDS));
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

  @Test
  void aRobotOfUnknownAddressIsFoundByItsBeacon() throws Exception {
    try (Station me = new Station(ME);
        Station other = new Station(OTHER)) {
      me.discover(ME, Map.of());
      other.discover(OTHER, Map.of(ME, me.radio.address()));

      assertThat(me.next()).isEqualTo("bot1 at " + other.radio.address().getPort());
    }
  }

  @Test
  void beaconsWithoutTheKeyOrFromAnotherAddressAreDroppedAndReported() throws Exception {
    try (Station me = new Station(ME);
        DatagramSocket stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      me.discover(ME, Map.of());
      Beacon honest = new Beacon(OTHER, 1, 1, stranger.getLocalAddress(), stranger.getLocalPort());
      Beacon passedOn = new Beacon(OTHER, 1, 1, stranger.getLocalAddress(), 1234);
      Beacon strange =
          new Beacon(new RobotId("spy"), 1, 1, stranger.getLocalAddress(), stranger.getLocalPort());
      List<byte[]> bytes = new ArrayList<>();
      bytes.add(new Beacon.Codec(otherKey()).write(honest));
      bytes.add(new Beacon.Codec(KEY).write(passedOn));
      bytes.add(new Beacon.Codec(KEY).write(strange));
      bytes.add(new Beacon.Codec(KEY).write(honest));
      for (byte[] datagram : bytes) {
        stranger.send(new DatagramPacket(datagram, datagram.length, me.radio.address()));
      }

      assertThat(me.next()).contains("not signed with the deployment's key");
      assertThat(me.next()).contains("names another source address");
      assertThat(me.next()).contains("robot that is not in the deployment");
      assertThat(me.next()).startsWith("bot1 at ");
    }
  }

  @Test
  void aSilentRobotIsSuspectedOnceAndMayReturn() {
    Neighbours neighbours = new Neighbours(ME, BOTH, 3 * S, 0);

    assertThat(neighbours.newlySuspected(3 * S)).isEmpty();
    assertThat(neighbours.newlySuspected(3 * S + 1)).containsExactly(OTHER);
    assertThat(neighbours.newlySuspected(9 * S)).isEmpty();
    assertThat(neighbours.hear(new Beacon(OTHER, 5, 1, null, 1), 9 * S))
        .isEqualTo(Neighbours.Verdict.APPEARED);
    assertThat(neighbours.lastHeardNs(OTHER)).isEqualTo(9 * S);
    assertThat(neighbours.newlySuspected(12 * S)).isEmpty();
    assertThat(neighbours.newlySuspected(12 * S + 1)).containsExactly(OTHER);
  }

  @Test
  void aReplayedBeaconDoesNotEndASuspicion() {
    Neighbours neighbours = new Neighbours(ME, BOTH, 3 * S, 0);
    Beacon recorded = new Beacon(OTHER, 5, 7, null, 1);
    neighbours.hear(recorded, S);

    assertThat(neighbours.hear(recorded, 2 * S)).isEqualTo(Neighbours.Verdict.OLD);
    assertThat(neighbours.hear(new Beacon(OTHER, 4, 99, null, 1), 2 * S))
        .isEqualTo(Neighbours.Verdict.OLD);
    assertThat(neighbours.lastHeardNs(OTHER)).isEqualTo(S);
    assertThat(neighbours.hear(new Beacon(OTHER, 6, 1, null, 1), 2 * S))
        .isEqualTo(Neighbours.Verdict.HEARD);
  }

  @Test
  void changedBeaconsAreRefused() throws Exception {
    long seed = 20251122;
    Rng rng = new Rng(seed);
    Beacon.Codec codec = new Beacon.Codec(KEY);
    Beacon.Codec unsigned = new Beacon.Codec(null);
    InetAddress address = InetAddress.getByAddress(new byte[] {10, 0, 0, 1});
    byte[] genuine = codec.write(new Beacon(OTHER, 5, 7, address, 4747));
    assertThat(codec.readOrNull(genuine, genuine.length))
        .isEqualTo(new Beacon(OTHER, 5, 7, address, 4747));
    for (int i = 0; i < 100_000; i++) {
      byte[] changed = Arrays.copyOf(genuine, rng.nextInt(2 * genuine.length));
      for (int flips = 1 + rng.nextInt(4); flips > 0 && changed.length > 0; flips--) {
        changed[rng.nextInt(changed.length)] ^= (byte) (1 << rng.nextInt(8));
      }
      boolean isSame = Arrays.equals(changed, genuine);
      assertThat(codec.readOrNull(changed, changed.length) != null)
          .as("seed %d, round %d", seed, i)
          .isEqualTo(isSame);
      unsigned.readOrNull(changed, changed.length);
    }
  }

  @Test
  void anExceptionOnTheRadiosThreadIsReported() throws Exception {
    try (Station me = new Station(ME);
        Station other = new Station(OTHER)) {
      me.isBroken = true;
      me.discover(ME, Map.of(OTHER, other.radio.address()));
      other.discover(OTHER, Map.of(ME, me.radio.address()));

      assertThat(me.next()).isEqualTo("failed");
      assertThat(me.radio.isClosed()).isTrue();
    }
  }

  @Test
  void anExceptionOnTheBeaconsThreadIsReported() throws Exception {
    try (Station me = new Station(ME)) {
      me.isBroken = true;
      me.discover(ME, Map.of(), 1);

      assertThat(me.next()).isEqualTo("failed");
    }
  }
}
