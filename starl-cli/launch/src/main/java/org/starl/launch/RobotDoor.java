package org.starl.launch;

import java.io.Closeable;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.starl.id.RobotId;
import org.starl.robot.realtime.Daemons;

/**
 * The robots' connections to a {@link WorldServer}: one for each robot, a later one in place of an earlier
 * one, and at most {@link #MAX_NAMELESS} that have not sent a robot's name. Of those the oldest is closed
 * for a new one, because a robot sends its name at once. Each connection has a thread.
 */
final class RobotDoor implements AutoCloseable {

  static final int MAX_NAMELESS = 64;

  private static final int NAME_WITHIN_MS = 5000;

  /** Takes a robot's words. On the connection's thread. */
  interface Guest {
    void talk(RobotId robot, Socket socket, DataInputStream in) throws IOException;
  }

  private final ServerSocket server;
  private final Predicate<RobotId> isKnown;
  private final Guest guest;
  private final LimitedLog log;
  private final Consumer<IOException> onFailure;

  // Guarded by this.
  private final Deque<Socket> nameless = new ArrayDeque<>();
  private final Map<RobotId, Socket> robots = new TreeMap<>();

  /**
   * @param isKnown whether the world has a body for this robot
   * @param onFailure takes the error that ends it
   */
  RobotDoor(
      ServerSocket server,
      Predicate<RobotId> isKnown,
      Guest guest,
      LimitedLog log,
      Consumer<IOException> onFailure) {
    this.server = server;
    this.isKnown = isKnown;
    this.guest = guest;
    this.log = log;
    this.onFailure = onFailure;
  }

  /** Accepts connections from now on, until it is closed. */
  void open() {
    Daemons.of("world accept", this::accept).start();
  }

  @Override
  public void close() throws IOException {
    server.close();
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket socket = server.accept();
        enter(socket);
        Daemons.of("world robot", () -> serve(socket)).start();
      } catch (IOException e) {
        if (!server.isClosed()) {
          onFailure.accept(e);
          return;
        }
      }
    }
  }

  private synchronized void enter(Socket socket) {
    nameless.addLast(socket);
    if (nameless.size() > MAX_NAMELESS) {
      log.log(
          "full",
          "more than "
              + MAX_NAMELESS
              + " connections without a robot's name: the oldest is closed");
      closeQuietly(nameless.removeFirst());
    }
  }

  private void serve(Socket socket) {
    try (socket;
        DataInputStream in = new DataInputStream(socket.getInputStream())) {
      socket.setSoTimeout(NAME_WITHIN_MS);
      String name = in.readUTF();
      if (!RobotId.isValid(name) || !isKnown.test(new RobotId(name))) {
        log.log("unknown", "no body for an unknown robot at " + socket.getRemoteSocketAddress());
        return;
      }
      socket.setSoTimeout(0);
      RobotId robot = new RobotId(name);
      replace(robot, socket);
      guest.talk(robot, socket, in);
    } catch (EOFException e) {
      return; // the robot has closed its connection
    } catch (IOException e) {
      log.log("lost", "a robot's connection: " + e.getMessage());
    } finally {
      leave(socket);
    }
  }

  private synchronized void replace(RobotId robot, Socket socket) {
    nameless.remove(socket);
    Socket before = robots.put(robot, socket);
    if (before != null) {
      log.log("again", robot + " connects again: its connection before is closed");
      closeQuietly(before);
    }
  }

  private synchronized void leave(Socket socket) {
    nameless.remove(socket);
    robots.values().remove(socket);
  }

  private void closeQuietly(Closeable socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.log("lost", "a connection cannot be closed: " + e.getMessage());
    }
  }
}
