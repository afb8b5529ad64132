package org.starl.deployment;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.function.Consumer;
import org.starl.id.RobotId;

/**
 * The hands that put one robot's body on the floor and take it off, in a deployment whose bodies are in
 * a {@link WorldProcess}: a line each way over TCP. Where robots are real, people have hands.
 */
final class Hands implements AutoCloseable {

  /** What is said, in small letters, one word a line; a robot begins with its name. */
  enum Word {
    /** Robot to world: put me on the floor where I start, once there is room. */
    PLACE,
    /** World to robot: it stands there. */
    PLACED,
    /** Robot to world: take me off the floor. */
    LIFT,
    /** World to robot: it is off. */
    LIFTED;

    String line() {
      return name().toLowerCase(Locale.ROOT) + "\n";
    }

    /** @throws IllegalArgumentException if it is none */
    static Word of(String line) {
      return valueOf(line.toUpperCase(Locale.ROOT));
    }
  }

  private static final int CONNECT_MS = 5000;

  private final InetSocketAddress world;
  private final RobotId robot;
  private final Socket socket;

  private Hands(InetSocketAddress world, RobotId robot, Socket socket) {
    this.world = world;
    this.robot = robot;
    this.socket = socket;
  }

  /** Connects. */
  static Hands open(InetSocketAddress world, RobotId robot) throws IOException {
    Socket socket = new Socket();
    try {
      socket.connect(world, CONNECT_MS);
      socket.setTcpNoDelay(true);
      socket.getOutputStream().write((robot + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      socket.close();
      throw trouble(world, e);
    }
    return new Hands(world, robot, socket);
  }

  /**
   * From now on hears the world. Once.
   *
   * @param heard takes what it says, on a thread of its own
   * @param lost is told that it is gone, or no world; not after {@link #close}
   */
  void listen(Consumer<Word> heard, Consumer<IOException> lost) {
    Thread reader = new Thread(() -> read(heard, lost), robot + " hands");
    reader.setDaemon(true);
    reader.start();
  }

  void say(Word word) throws IOException {
    try {
      socket.getOutputStream().write(word.line().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw trouble(world, e);
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }

  private void read(Consumer<Word> heard, Consumer<IOException> lost) {
    try (ShortLines lines = new ShortLines(new BufferedInputStream(socket.getInputStream()))) {
      for (String line = lines.next(); line != null; line = lines.next()) {
        heard.accept(Word.of(line));
      }
      throw new IOException("is gone");
    } catch (IOException | IllegalArgumentException e) {
      if (!socket.isClosed()) {
        lost.accept(trouble(world, e));
      }
    }
  }

  private static IOException trouble(InetSocketAddress world, Exception cause) {
    return new IOException("world at " + world + ": " + cause.getMessage(), cause);
  }
}
