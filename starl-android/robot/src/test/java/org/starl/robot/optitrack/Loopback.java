package org.starl.robot.optitrack;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketTimeoutException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;

/** Servers and clients on the loopback interface, and what came out of them. */
final class Loopback {

  static final InetAddress HOST = InetAddress.getLoopbackAddress();

  final List<Exception> failures = new CopyOnWriteArrayList<>();
  final List<String> lines = new CopyOnWriteArrayList<>();
  final LogSink log = (timeNs, level, tag, line) -> lines.add(level + " " + line);

  /** A group, with a port that nobody has. */
  static InetSocketAddress freeGroup() {
    try (DatagramSocket socket = new DatagramSocket(0)) {
      return new InetSocketAddress(NatNetSettings.GROUP, socket.getLocalPort());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Skips the test that calls it where the loopback interface carries no multicast. */
  static void assumeMulticast() {
    InetSocketAddress group = freeGroup();
    boolean isCarried = false;
    String why = "nothing arrived";
    try (MulticastSocket hearing = new MulticastSocket(group.getPort());
        MulticastSocket sending = new MulticastSocket()) {
      NetworkInterface loopback = NetworkInterface.getByInetAddress(HOST);
      hearing.joinGroup(group, loopback);
      sending.setNetworkInterface(loopback);
      sending.send(new DatagramPacket(new byte[1], 1, group));
      hearing.setSoTimeout(2000);
      hearing.receive(new DatagramPacket(new byte[2], 2));
      isCarried = true;
    } catch (SocketTimeoutException e) {
      why = "nothing arrived in 2 s";
    } catch (IOException e) {
      why = e.toString();
    }
    assumeTrue(isCarried, "no multicast on the loopback interface here: " + why);
  }

  /** A server of version 4.1 that streams to each client, at any free port. */
  static NatNetServerSettings server() {
    return server(null, NatNetVersion.V4_1, Axes.DEFAULT, 100);
  }

  static NatNetServerSettings server(
      InetSocketAddress group, NatNetVersion version, Axes axes, int framesPerS) {
    return new NatNetServerSettings(
        new InetSocketAddress(HOST, 0), group, version, axes, framesPerS);
  }

  NatNetServer serve(NatNetServerSettings settings, PoseSource source, Clock clock) {
    try {
      return NatNetServer.open(settings, source, clock, failures::add);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A client of {@code server}, with what is changed of its settings. */
  NatNetClient connect(NatNetServer server, NatNetSettings settings, Clock clock) {
    try {
      return NatNetClient.open(
          new NatNetSettings(
              server.address(), settings.group(), HOST, settings.axes(), settings.bounds()),
          clock,
          log);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  JsonFeed listen(FixBounds bounds, Clock clock) {
    try {
      return JsonFeed.open(
          new JsonFeedSettings(new InetSocketAddress(HOST, 0), null, null, bounds), clock, log);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Sends one datagram from a socket of its own. */
  static void send(byte[] datagram, InetSocketAddress to) {
    withSocket(socket -> {
      try {
        socket.send(new DatagramPacket(datagram, datagram.length, to));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    });
  }

  static void withSocket(Consumer<DatagramSocket> use) {
    try (DatagramSocket socket = new DatagramSocket(0, HOST)) {
      use.accept(socket);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
