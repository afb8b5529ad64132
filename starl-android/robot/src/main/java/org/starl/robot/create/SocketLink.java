package org.starl.robot.create;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;

/** A {@link ByteLink} over TCP, as serial servers and simulated robots offer it. */
public final class SocketLink implements ByteLink {

  private static final int CONNECT_MS = 3000;

  private final Socket socket;

  /**
   * Over a connected socket; small writes leave at once.
   *
   * @throws IOException if it is closed
   */
  public SocketLink(Socket socket) throws IOException {
    this.socket = socket;
    socket.setTcpNoDelay(true);
  }

  /** Links to the listener at {@code host:port}. */
  public static Source to(String host, int port) {
    return () -> {
      Socket socket = new Socket();
      try {
        socket.connect(new InetSocketAddress(host, port), CONNECT_MS);
        return new SocketLink(socket);
      } catch (IOException e) {
        socket.close();
        throw e;
      }
    };
  }

  @Override
  public InputStream input() throws IOException {
    return socket.getInputStream();
  }

  @Override
  public OutputStream output() throws IOException {
    return socket.getOutputStream();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }

  @Override
  public String toString() {
    return String.valueOf(socket.getRemoteSocketAddress());
  }
}
