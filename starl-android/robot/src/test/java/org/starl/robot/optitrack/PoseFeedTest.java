package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("realtime")
class PoseFeedTest {

  private static final InetSocketAddress ANY =
      new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

  @Test
  void anExceptionOfTheReceiverIsReported() throws Exception {
    DatagramSocket socket = new DatagramSocket(ANY);
    BlockingQueue<String> told = new LinkedBlockingQueue<>();
    PoseFeed feed =
        new PoseFeed(() -> 0, (timeNs, level, tag, line) -> told.add(line), "test") {
          @Override
          List<TrackedBody> read(@Nullable DatagramPacket packet, long nowNs) {
            throw new IllegalStateException("a bug");
          }
        };
    feed.receive("test", socket, 60_000);
    try (DatagramSocket sender = new DatagramSocket(ANY)) {
      sender.send(new DatagramPacket(new byte[1], 1, socket.getLocalSocketAddress()));
    }

    assertThat(told.poll(60, TimeUnit.SECONDS))
        .isEqualTo("no more fixes: java.lang.IllegalStateException: a bug");
    assertThat(socket.isClosed()).isTrue();
    feed.close();
    assertThat(told).isEmpty();
  }
}
