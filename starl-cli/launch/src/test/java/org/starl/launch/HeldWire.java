package org.starl.launch;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.robot.realtime.Daemons;

/** Passes bytes between clients and a server over TCP; each direction can be held and released. */
final class HeldWire implements AutoCloseable {

  /** One direction. */
  static final class Gate {
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition opened = lock.newCondition();
    private boolean isHeld;

    void hold() {
      set(true);
    }

    void release() {
      set(false);
    }

    private void set(boolean held) {
      lock.lock();
      try {
        isHeld = held;
        opened.signalAll();
      } finally {
        lock.unlock();
      }
    }

    void await() {
      lock.lock();
      try {
        while (isHeld) {
          opened.awaitUninterruptibly();
        }
      } finally {
        lock.unlock();
      }
    }
  }

  final Gate toServer = new Gate();
  final Gate toClient = new Gate();
  private final ServerSocket front = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
  private final int server;

  HeldWire(int server) throws IOException {
    this.server = server;
    Daemons.of("held wire", this::accept).start();
  }

  int port() {
    return front.getLocalPort();
  }

  private void accept() {
    while (!front.isClosed()) {
      try {
        Socket client = front.accept();
        Socket there = new Socket(InetAddress.getLoopbackAddress(), server);
        client.setTcpNoDelay(true);
        there.setTcpNoDelay(true);
        Daemons.of("to server", () -> pump(client, there, toServer)).start();
        Daemons.of("to client", () -> pump(there, client, toClient)).start();
      } catch (IOException e) {
        if (!front.isClosed()) {
          throw new IllegalStateException(e);
        }
      }
    }
  }

  private static void pump(Socket from, Socket to, Gate gate) {
    byte[] buffer = new byte[256];
    try (from;
        to) {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        gate.await();
        out.write(buffer, 0, n);
      }
    } catch (IOException e) {
      return; // one end was closed, which closes the other
    }
  }

  @Override
  public void close() throws IOException {
    front.close();
  }
}
