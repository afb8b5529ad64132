package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.robot.contract.RadioContract;

/** UDP on the loopback interface: the contract, and what only a network can do. */
@Tag("realtime")
class UdpRadioTest extends RadioContract {

  @Override
  protected Air newAir() {
    return new UdpAir();
  }

  @Test
  void foreignAndOversizeDatagramsAreCountedAndDropped() throws Exception {
    try (UdpAir air = new UdpAir();
        DatagramSocket stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        DatagramSocket peer = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      UdpRadio radio = air.radio(0);
      List<String> told = new CopyOnWriteArrayList<>();
      radio.onDrop(told::add);
      List<Integer> lengths = new CopyOnWriteArrayList<>();
      CountDownLatch heard = new CountDownLatch(1);
      air.ground(0)
          .strand()
          .post(() ->
              radio.onReceive((buffer, length) -> {
                lengths.add(length);
                heard.countDown();
              }));
      radio.setPeer(
          new RobotId("peer"), new InetSocketAddress(peer.getLocalAddress(), peer.getLocalPort()));
      stranger.send(new DatagramPacket(new byte[5], 5, radio.address()));
      stranger.send(new DatagramPacket(new byte[5], 5, radio.address()));
      peer.send(new DatagramPacket(new byte[9000], 9000, radio.address()));
      peer.send(new DatagramPacket(new byte[7], 7, radio.address()));
      assertThat(heard.await(60, TimeUnit.SECONDS)).isTrue();
      assertThat(lengths).containsExactly(7);
      assertThat(radio.statistics())
          .isEqualTo(new UdpStatistics(0, 0, 1, Map.of(UdpDrop.FOREIGN, 2L, UdpDrop.OVERSIZE, 1L)));
      assertThat(told).hasSize(2).allMatch(line -> line.contains("more of these are only counted"));
    }
  }

  @Test
  void aFloodTooFastForTheStrandIsDropped() throws Exception {
    try (UdpAir air = new UdpAir()) {
      UdpRadio radio = air.radio(0);
      CountDownLatch release = new CountDownLatch(1);
      air.ground(0).strand().post(() -> waitFor(release));
      byte[] datagram = new byte[1];
      for (int i = 0; radio.statistics().dropped(UdpDrop.OVERFLOW) == 0; i++) {
        assertThat(i).isLessThan(1_000_000);
        air.radio(1).send(new RobotId("robot0"), datagram, 1);
      }
      assertThat(radio.statistics().received()).isEqualTo(UdpRadio.MAX_WAITING);
      release.countDown();
    }
  }

  @Test
  void failedSendsAreCounted() {
    try (UdpAir air = new UdpAir()) {
      UdpRadio radio = air.radio(0);
      radio.send(new RobotId("nobody"), new byte[3], 3);
      radio.send(new RobotId("robot1"), new byte[3], 3);
      assertThat(radio.statistics().unsent()).isEqualTo(1);
      assertThat(radio.statistics().sent()).isEqualTo(1);
      radio.close();
      radio.broadcast(new byte[3], 3);
      assertThat(radio.statistics().unsent()).isEqualTo(3);
    }
  }

  @Test
  void aClosedRadioReleasesItsAddress() throws IOException {
    try (UdpAir air = new UdpAir()) {
      InetSocketAddress address = air.radio(0).address();
      assertThatThrownBy(() -> new DatagramSocket(address)).isInstanceOf(BindException.class);
      air.radio(0).close();
      air.radio(0).close();
      new DatagramSocket(address).close();
    }
  }

  @Test
  void theLongestDatagramFitsAFrame() {
    int ethernetPayload = 1500;
    int ipAndUdpHeaders = 20 + 8;
    assertThat(Radio.MAX_BYTES + ipAndUdpHeaders).isLessThanOrEqualTo(ethernetPayload);
  }

  private static void waitFor(CountDownLatch latch) {
    try {
      assertThat(latch.await(60, TimeUnit.SECONDS)).isTrue();
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    }
  }
}
