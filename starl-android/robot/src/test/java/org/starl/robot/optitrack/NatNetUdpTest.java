package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.robot.contract.RealGround;
import org.starl.robot.realtime.RealClock;

/** Client and server over real sockets of the loopback interface. */
@Tag("realtime")
class NatNetUdpTest {

  private static final Pose POSE = new Pose(1234.5, -678.25, 2.5);

  private final Clock clock = new RealClock();
  private final Loopback loopback = new Loopback();

  private PoseSource still() {
    return () ->
        new PoseSource.Snapshot(
            clock.nowNs(),
            List.of(
                new PoseSource.Body("lost one", new Pose(0, 0, 0), false, 0),
                new PoseSource.Body("bot0", POSE, true, 4)));
  }

  static Stream<Arguments> versionsAndAxes() {
    return NatNetServerSettings.VERSIONS.stream()
        .flatMap(version ->
            Stream.of(
                Arguments.of(version, new Axes(UpAxis.Y, BodyAxis.PLUS_X)),
                Arguments.of(version, new Axes(UpAxis.Z, BodyAxis.MINUS_Y))));
  }

  @ParameterizedTest
  @MethodSource("versionsAndAxes")
  void unicastDeliversNameAndPoseOfEachBody(NatNetVersion version, Axes axes)
      throws InterruptedException {
    exchange(null, version, axes);
  }

  @ParameterizedTest
  @MethodSource("versionsAndAxes")
  void multicastDeliversNameAndPoseOfEachBody(NatNetVersion version, Axes axes)
      throws InterruptedException {
    Loopback.assumeMulticast();
    exchange(Loopback.freeGroup(), version, axes);
  }

  private void exchange(InetSocketAddress group, NatNetVersion version, Axes axes)
      throws InterruptedException {
    NatNetServerSettings serving = Loopback.server(group, version, axes, 100);
    NatNetSettings settings =
        new NatNetSettings(
            new InetSocketAddress(Loopback.HOST, 1510), group, null, axes, FixBounds.DEFAULT);
    try (NatNetServer server = loopback.serve(serving, still(), clock);
        NatNetClient client = loopback.connect(server, settings, clock)) {
      BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
      client.onBodies(heard::add);
      List<TrackedBody> bodies = next(heard);
      assertThat(bodies).extracting(TrackedBody::name).containsExactly("lost one", "bot0");
      assertThat(bodies).extracting(TrackedBody::id).containsExactly(1, 2);
      assertThat(bodies.get(0).fix()).isNull();
      assertPose(bodies.get(1).fix());
      assertThat(client.isConnected()).isTrue();
      assertThat(client.statistics().dropped(FeedDrop.LOST)).isPositive();
      assertThat(client.statistics().dropped(FeedDrop.MALFORMED)).isZero();
      assertThat(client.statistics().dropped(FeedDrop.UNKNOWN)).isZero();
      assertThat(server.ignored()).isZero();
    }
    assertThat(loopback.failures).isEmpty();
    assertThat(loopback.lines)
        .contains("INFO connected to StarL, NatNet " + version)
        .doesNotHaveDuplicates();
  }

  private static void assertPose(Fix fix) {
    assertThat(fix).isNotNull();
    assertThat(fix.pose().distanceMm(POSE.at())).isLessThan(0.01);
    assertThat(Math.abs(Angles.difference(fix.pose().headingRad(), POSE.headingRad())))
        .isLessThan(1e-5);
    // Three times the mean error of the markers, and what is not known of the time.
    assertThat(fix.errorMm()).isBetween(12.0, 12.0 + 500 * 0.2);
  }

  @Test
  void aBodyCanBeIdentifiedByItsNumber() {
    RealGround ground = new RealGround("bot0");
    BlockingQueue<Fix> fixes = new LinkedBlockingQueue<>();
    try (NatNetServer server = loopback.serve(Loopback.server(), still(), clock);
        NatNetClient client =
            loopback.connect(server, NatNetSettings.unicast(Loopback.HOST), clock)) {
      client.positioning(ground.strand(), 2).onFix(fixes::add);
      client.positioning(ground.strand(), 1).onFix(fix -> ground.errors().add(new Exception()));
      assertPose(next(fixes));
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    } finally {
      ground.close();
    }
    assertThat(ground.errors()).isEmpty();
  }

  @Test
  void aRestartedServerIsFoundAgain() throws InterruptedException {
    NatNetServerSettings serving = Loopback.server();
    BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
    NatNetServer first = loopback.serve(serving, still(), clock);
    int port = first.address().getPort();
    try (NatNetClient client =
        loopback.connect(first, NatNetSettings.unicast(Loopback.HOST), clock)) {
      client.onBodies(heard::add);
      next(heard);
      first.close();
      heard.clear();
      long restartNs = clock.nowNs();
      Clock newClock = new RealClock(RealClock.machineNs() + 5_000_000_000L);
      PoseSource anew =
          () ->
              new PoseSource.Snapshot(
                  newClock.nowNs(), List.of(new PoseSource.Body("bot9", POSE, true, 4)));
      try (NatNetServer second =
          NatNetServer.open(
              new NatNetServerSettings(
                  new InetSocketAddress(Loopback.HOST, port),
                  null,
                  serving.version(),
                  serving.axes(),
                  100),
              anew,
              newClock,
              loopback.failures::add)) {
        assertThat(second.address().getPort()).isEqualTo(port);
        List<TrackedBody> bodies = next(heard);
        while (!bodies.get(0).name().equals("bot9")) {
          bodies = next(heard);
        }
        assertPose(bodies.get(0).fix());
        long slackNs = 200_000_000;
        assertThat(bodies.get(0).fix().timeNs()).isBetween(restartNs - slackNs, clock.nowNs());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void anUnknownNameIsReported() throws InterruptedException {
    RealGround ground = new RealGround("bot7");
    BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
    try (NatNetServer server = loopback.serve(Loopback.server(), still(), clock);
        NatNetClient client =
            loopback.connect(server, NatNetSettings.unicast(Loopback.HOST), clock)) {
      client.onBodies(heard::add);
      client.positioning(ground.strand(), "bot7").onFix(fix -> {});
      next(heard);
    } finally {
      ground.close();
    }
    assertThat(loopback.lines)
        .contains("WARN no rigid body has the name bot7: there are [lost one, bot0]");
  }

  @Test
  void shortAndLongConnectMessagesAreAnsweredAlike() {
    try (NatNetServer server = loopback.serve(Loopback.server(), still(), clock)) {
      byte[] shortForm = new LittleEndianWriter().begin(Message.CONNECT).name("Ping").end();
      byte[] longForm =
          new LittleEndianWriter().begin(Message.CONNECT).fixedName("Ping", 270).end();
      assertThat(shortForm).hasSize(4 + 5);
      assertThat(longForm).hasSize(4 + 270);
      for (byte[] connect : List.of(shortForm, longForm)) {
        Loopback.withSocket(socket -> {
          DatagramPacket answer = new DatagramPacket(new byte[2000], 2000);
          try {
            socket.setSoTimeout(60_000);
            socket.send(new DatagramPacket(connect, connect.length, server.address()));
            socket.receive(answer);
            assertThat(answer.getLength()).isEqualTo(4 + 279);
            assertThat(ServerInfo.parse(Message.payload(answer.getData(), 283)))
                .isEqualTo(
                    new ServerInfo("StarL", NatNetVersion.V4_1, 1_000_000_000, false, 1511, 0));
            socket.receive(answer);
            assertThat(Message.id(answer.getData(), answer.getLength())).isEqualTo(Message.FRAME);
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        });
      }
      Loopback.send(new byte[3], server.address());
    }
  }

  @Test
  void datagramsFromOtherAddressesAreCountedAndDropped() throws InterruptedException {
    Loopback.assumeMulticast();
    InetSocketAddress group = Loopback.freeGroup();
    BlockingQueue<List<TrackedBody>> heard = new LinkedBlockingQueue<>();
    RealClock now = new RealClock();
    // The server is another host, from where nothing comes: all is foreign.
    NatNetSettings settings =
        new NatNetSettings(
            new InetSocketAddress("127.0.0.2", 1510),
            group,
            Loopback.HOST,
            Axes.DEFAULT,
            FixBounds.DEFAULT);
    NatNetServerSettings serving = Loopback.server(group, NatNetVersion.V4_1, Axes.DEFAULT, 1000);
    try (NatNetServer server = loopback.serve(serving, still(), clock);
        NatNetClient client = NatNetClient.open(settings, now, loopback.log)) {
      client.onBodies(heard::add);
      long untilNs = now.nowNs() + 60_000_000_000L;
      while (client.statistics().dropped(FeedDrop.FOREIGN) < 10 && now.nowNs() < untilNs) {
        assertThat(heard.poll(10, TimeUnit.MILLISECONDS)).isNull();
      }
      assertThat(client.statistics().dropped(FeedDrop.FOREIGN)).isGreaterThanOrEqualTo(10);
      assertThat(client.isConnected()).isFalse();
      assertThat(server.ignored()).isZero();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    assertThat(loopback.lines).filteredOn(line -> line.contains("FOREIGN")).hasSize(1);
  }

  @Test
  void anAddressInUseIsReportedInOneLine() {
    try (NatNetServer server = loopback.serve(Loopback.server(), still(), clock)) {
      NatNetServerSettings same =
          new NatNetServerSettings(server.address(), null, NatNetVersion.V4_1, Axes.DEFAULT, 100);
      assertThatThrownBy(() -> NatNetServer.open(same, still(), clock, loopback.failures::add))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("NatNet server at")
          .hasMessageContaining(String.valueOf(server.address().getPort()));
    }
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T element = queue.poll(60, TimeUnit.SECONDS);
    assertThat(element).as("something within a minute").isNotNull();
    return element;
  }
}
