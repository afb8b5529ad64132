package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Which senders a NatNet server serves while it is flooded; in virtual time. */
class StreamClientsTest {

  private static final long MS = 1_000_000;
  private static final long S = 1000 * MS;

  private final StreamClients clients = new StreamClients();

  /** One of 65,536 hosts. */
  private static InetSocketAddress host(int number, int port) throws UnknownHostException {
    byte[] address = {10, 0, (byte) (number >> 8), (byte) number};
    return new InetSocketAddress(InetAddress.getByAddress(address), port);
  }

  /** As a NatNet server does with a connect message. */
  private boolean connect(InetSocketAddress client, long nowNs) {
    return clients.heard(client, nowNs) && clients.add(client, nowNs);
  }

  @Test
  void aFloodOfFalseClientsTakesNothingFromAKnownClient() throws UnknownHostException {
    InetSocketAddress robot = host(1, 1000);
    assertThat(connect(robot, 0)).isTrue();

    // 3,000 a second for a minute, each from another address; the robot sends once a second.
    for (int i = 0; i < 180_000; i++) {
      long nowNs = i * S / 3000;
      connect(host(2 + i % 60_000, 1000), nowNs);
      clients.removeSilent(nowNs);
      if (i % 3000 == 2999) {
        assertThat(clients.heard(robot, nowNs)).isTrue();
      }
      assertThat(clients.all()).contains(robot).hasSizeLessThanOrEqualTo(StreamClients.MAX);
    }
  }

  @Test
  void aForgedDisconnectTakesNothingFromAClientThatIsHeardAgain() throws UnknownHostException {
    InetSocketAddress robot = host(1, 1000);
    connect(robot, 0);
    for (long nowNs = S; nowNs <= 20 * S; nowNs += S) {
      assertThat(clients.leave(robot, nowNs)).isTrue();
      clients.removeSilent(nowNs + S - MS);
      assertThat(clients.heard(robot, nowNs + S - MS)).isTrue();
      assertThat(clients.all()).containsExactly(robot);
    }
  }

  @Test
  void aClientThatLeavesIsRemoved() throws UnknownHostException {
    InetSocketAddress robot = host(1, 1000);
    connect(robot, 0);
    assertThat(clients.leave(host(1, 1001), S)).as("from another address").isFalse();
    assertThat(clients.leave(robot, S)).isTrue();
    clients.removeSilent(S + StreamClients.LEAVE_NS);
    assertThat(clients.all()).containsExactly(robot);
    clients.removeSilent(S + StreamClients.LEAVE_NS + MS);
    assertThat(clients.all()).isEmpty();
  }

  @Test
  void strangersShareOneRate() throws UnknownHostException {
    int answered = 0;
    for (int i = 0; i < 30_000; i++) {
      answered += clients.heard(host(i, 1000), i * 10 * S / 30_000) ? 1 : 0;
    }
    assertThat(answered).isEqualTo(10 * StreamClients.STRANGERS_PER_S);
  }

  @Test
  void oneHostTakesHalfOfThePlacesAtMost() throws UnknownHostException {
    for (int port = 1; port <= StreamClients.MAX; port++) {
      assertThat(clients.add(host(1, port), 0)).isEqualTo(port <= StreamClients.MAX_PER_HOST);
    }
    assertThat(clients.add(host(2, 1), 0)).isTrue();
  }

  @Test
  void aHostWithReservedPlacesComesInThoughAllOthersAreTaken() throws UnknownHostException {
    InetSocketAddress robot = host(1, 1000);
    clients.reserve(Set.of(robot.getAddress()));
    for (int i = 0; i < 3000; i++) {
      connect(host(2 + i, 1000), i * S / 3000);
    }
    assertThat(clients.all()).hasSize(StreamClients.MAX);

    assertThat(connect(robot, S - 1)).isTrue();
    clients.leave(robot, S - 1);
    assertThat(connect(robot, S - 1)).as("after a restart").isTrue();
    for (int port = 1; port < StreamClients.MAX; port++) {
      connect(host(1, port), S - 1);
    }
    assertThat(clients.all()).hasSize(StreamClients.MAX + StreamClients.MAX_PER_HOST);
  }

  @Test
  void aSilentClientIsRemovedAndItsPlaceIsFree() throws UnknownHostException {
    for (int i = 0; i < StreamClients.MAX; i++) {
      clients.add(host(i, 1), i * MS);
    }
    assertThat(clients.add(host(100, 1), S)).isFalse();
    assertThat(clients.add(host(5, 1), S)).as("a known client").isTrue();

    clients.removeSilent(StreamClients.SILENCE_NS + 1);

    assertThat(clients.all()).doesNotContain(host(0, 1)).contains(host(1, 1), host(5, 1));
    assertThat(clients.add(host(100, 1), StreamClients.SILENCE_NS + 1)).isTrue();
  }
}
