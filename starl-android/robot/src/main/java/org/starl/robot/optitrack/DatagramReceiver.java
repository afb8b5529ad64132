package org.starl.robot.optitrack;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.SocketTimeoutException;
import org.jspecify.annotations.Nullable;

/** Receives datagrams of any size from a socket into one buffer of its own. */
final class DatagramReceiver {

  // One byte more than UDP can carry, so that no datagram is cut off silently.
  private final DatagramPacket packet =
      new DatagramPacket(new byte[Message.MAX_BYTES + 1], Message.MAX_BYTES + 1);

  private final DatagramSocket socket;

  DatagramReceiver(DatagramSocket socket) {
    this.socket = socket;
  }

  /** The next datagram, valid until the next call; null if none arrives within this time. */
  @Nullable DatagramPacket receive(int withinMs) throws IOException {
    packet.setLength(Message.MAX_BYTES + 1);
    socket.setSoTimeout(withinMs);
    try {
      socket.receive(packet);
      return packet;
    } catch (SocketTimeoutException e) {
      return null;
    }
  }
}
