package org.starl.robot.optitrack;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.sim.check.MalformedBytes;

/**
 * Any datagrams to the server, from any of 256 clients: each input is datagrams, each behind its client's
 * number and its length. It answers or counts each, and remembers no more clients than it says.
 */
@Tag("realtime")
public class NatNetServerFuzzTest {

  /** Where all answers go: a socket of this test, on every loopback address. */
  private static final DatagramSocket SINK = sink();

  private static final NatNetServer SERVER = server();
  private static long nowNs;

  private static DatagramSocket sink() {
    try {
      return new DatagramSocket(0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static NatNetServer server() {
    PoseSource.Snapshot snapshot =
        new PoseSource.Snapshot(
            0, List.of(new PoseSource.Body("bot0", new Pose(1, 2, 3), true, 0)));
    try {
      return NatNetServer.bind(
          Loopback.server(),
          () -> snapshot,
          () -> nowNs,
          failure -> {
            throw new AssertionError(failure);
          });
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public static void fuzzerTestOneInput(byte[] input) {
    for (int at = 0; input.length - at >= 2; ) {
      int length = Math.min(input[at + 1] & 0xFF, input.length - at - 2);
      byte[] datagram = Arrays.copyOfRange(input, at + 2, at + 2 + length);
      long ignored = SERVER.ignored();
      SERVER.answer(
          new DatagramPacket(
              datagram, length, new InetSocketAddress(client(input[at]), SINK.getLocalPort())),
          ++nowNs);
      long more = SERVER.ignored() - ignored;
      // An answer that a machine without this loopback address cannot send counts as ignored, too.
      require(more == 1 || (more == 0 && isMessage(datagram)), "ignored " + more);
      require(SERVER.clients() <= StreamClients.MAX, SERVER.clients() + " clients");
      at += 2 + length;
    }
  }

  /** Whether these bytes are something that a server knows, as NatNet has it. */
  private static boolean isMessage(byte[] bytes) {
    if (bytes.length < 4 || (bytes[2] & 0xFF | (bytes[3] & 0xFF) << 8) > bytes.length - 4) {
      return false;
    }
    return switch (bytes[0] & 0xFF | (bytes[1] & 0xFF) << 8) {
      case 0, 2, 4, 9, 10, 14 -> true;
      case 12 -> (bytes[2] & 0xFF | (bytes[3] & 0xFF) << 8) >= 8;
      default -> false;
    };
  }

  private static InetAddress client(byte number) {
    try {
      return InetAddress.getByAddress(new byte[] {127, 0, 0, number == 0 ? 1 : number});
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  private static byte[] from(int client, byte[] datagram) {
    byte[] bytes = new byte[2 + Math.min(datagram.length, 255)];
    bytes[0] = (byte) client;
    bytes[1] = (byte) (bytes.length - 2);
    System.arraycopy(datagram, 0, bytes, 2, bytes.length - 2);
    return bytes;
  }

  @Test
  void noDatagramBreaksTheServer() {
    LittleEndianWriter out = new LittleEndianWriter();
    List<byte[]> samples = new ArrayList<>();
    samples.add(from(1, out.begin(Message.CONNECT).fixedName("Ping", 240).end()));
    samples.add(from(2, out.begin(Message.CONNECT).u8(0).end()));
    samples.add(from(1, out.begin(Message.REQUEST_MODELS).end()));
    samples.add(from(3, out.begin(Message.ECHO_REQUEST).i64(7).end()));
    samples.add(from(1, out.begin(Message.KEEP_ALIVE).end()));
    samples.add(from(2, out.begin(Message.DISCONNECT).end()));
    samples.add(from(9, out.begin(Message.DISCOVERY).end()));
    samples.add(from(8, out.begin(Message.REQUEST).name("FrameRate").end()));

    MalformedBytes.feed(samples, NatNetServerFuzzTest::fuzzerTestOneInput);
  }
}
