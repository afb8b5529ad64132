package org.starl.robot.optitrack;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.robot.realtime.Daemons;

/** One socket and the thread that takes what comes, until it is closed. */
final class Reception implements AutoCloseable {

  private final DatagramSocket socket;
  private final Thread thread;

  private Reception(DatagramSocket socket, Thread thread) {
    this.socket = socket;
    this.thread = thread;
  }

  /**
   * Begins.
   *
   * @param name of the thread
   * @param taker takes each datagram, or null when none has come for {@code waitMs}
   * @param onFailure is called, on that thread, if it cannot continue; the socket is closed then
   */
  static Reception start(
      String name,
      DatagramSocket socket,
      int waitMs,
      Consumer<@Nullable DatagramPacket> taker,
      Consumer<Exception> onFailure) {
    Thread thread = Daemons.of(name, () -> run(socket, waitMs, taker, onFailure));
    thread.start();
    return new Reception(socket, thread);
  }

  private static void run(
      DatagramSocket socket,
      int waitMs,
      Consumer<@Nullable DatagramPacket> taker,
      Consumer<Exception> onFailure) {
    DatagramReceiver receiver = new DatagramReceiver(socket);
    while (!socket.isClosed()) {
      try {
        taker.accept(receiver.receive(waitMs));
      } catch (IOException | RuntimeException e) {
        if (!socket.isClosed()) {
          socket.close();
          onFailure.accept(e);
        }
      }
    }
  }

  /** Takes nothing more. */
  @Override
  public void close() {
    socket.close();
    Daemons.join(thread, 0);
  }
}
