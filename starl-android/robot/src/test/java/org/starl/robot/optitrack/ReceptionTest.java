package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("realtime")
class ReceptionTest {

  private static final InetSocketAddress ANY =
      new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

  @Test
  void anExceptionOfTheReceiverIsReported() throws Exception {
    IllegalStateException bug = new IllegalStateException("a bug");
    BlockingQueue<Exception> told = new LinkedBlockingQueue<>();
    DatagramSocket socket = new DatagramSocket(ANY);
    Reception reception =
        Reception.start(
            "test",
            socket,
            60_000,
            packet -> {
              throw bug;
            },
            told::add);
    try (DatagramSocket sender = new DatagramSocket(ANY)) {
      sender.send(new DatagramPacket(new byte[1], 1, socket.getLocalSocketAddress()));
    }

    assertThat(told.poll(60, TimeUnit.SECONDS)).isSameAs(bug);
    assertThat(socket.isClosed()).isTrue();
    reception.close();
    assertThat(told).isEmpty();
  }
}
