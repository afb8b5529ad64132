package org.starl.robot.create;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;

/** A {@link ByteLink} over TCP, as serial servers and simulated robots offer it. */
public final class SocketLink {

  private static final int CONNECT_MS = 3000;

  private SocketLink() {}

  /**
   * A link over a connected socket; small writes leave at once.
   *
   * @throws IOException if the socket is closed
   */
  static ByteLink of(Socket socket) throws IOException {
    socket.setTcpNoDelay(true);
    return new StreamLink(
        String.valueOf(socket.getRemoteSocketAddress()),
        socket.getInputStream(),
        socket.getOutputStream(),
        socket);
  }

  /** Links to the listener at {@code host:port}. */
  public static ByteLink.Source to(String host, int port) {
    return () -> {
      Socket socket = new Socket();
      try {
        socket.connect(new InetSocketAddress(host, port), CONNECT_MS);
        return of(socket);
      } catch (IOException e) {
        socket.close();
        throw e;
      }
    };
  }
}
