package org.starl.robot.create;

import java.io.IOException;
import java.io.OutputStream;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.robot.realtime.Daemons;

/**
 * Runs a {@link SimulatedCreate} in real time at the far end of a link, in place of the hardware. A
 * lost link does not stop the robot: like a real one it continues its last command.
 */
public final class CreateHost implements AutoCloseable {

  /** Bytes that wait for a driver that does not read; like a serial line it loses the rest. */
  private static final int QUEUE_BYTES = 4096;

  private final String name;
  private final Clock clock;
  private final Consumer<IOException> onLinkEnd;
  private final Guard guard = new Guard();
  private final Thread ticker;

  // Guarded.
  private final SimulatedCreate robot;
  private WriteQueue toDriver = new WriteQueue(QUEUE_BYTES);
  private @Nullable ByteLink link;
  private @Nullable ServerSocket server;
  private boolean isClosed;

  private CreateHost(
      String name,
      CreateModel model,
      CreateBody body,
      Clock clock,
      Consumer<IOException> onLinkEnd) {
    this.name = name;
    this.clock = clock;
    this.onLinkEnd = onLinkEnd;
    robot = new SimulatedCreate(model, body, bytes -> toDriver.offer(bytes));
    ticker = thread("clock", this::tick);
  }

  /**
   * Switches a robot on, until {@link #close}.
   *
   * @param name of the threads
   * @param body is called on threads of this host, one at a time
   * @param onLinkEnd receives the reason of each link's end, on a thread of this host
   */
  public static CreateHost start(
      String name,
      CreateModel model,
      CreateBody body,
      Clock clock,
      Consumer<IOException> onLinkEnd) {
    CreateHost host = new CreateHost(name, model, body, clock, onLinkEnd);
    host.ticker.start();
    return host;
  }

  /** Serves {@code newLink} from now on and closes the link before it. Returns at once. */
  public void serve(ByteLink newLink) {
    thread("line", () -> talk(newLink)).start();
  }

  /** Serves clients of {@code newServer}, one after another; closes the server at the end. */
  public void listen(ServerSocket newServer) {
    guard.run(() -> server = newServer);
    thread("server", () -> accept(newServer)).start();
  }

  /** Runs {@code inspector} with exclusive access to the robot. */
  public void inspect(Consumer<SimulatedCreate> inspector) {
    guard.run(() -> inspector.accept(robot));
  }

  /** Switches the robot off, and ends its link. */
  @Override
  public void close() {
    guard.run(() -> {
      isClosed = true;
      guard.signal();
      toDriver.close();
      WriteQueue.closeQuietly(link);
      WriteQueue.closeQuietly(server);
    });
  }

  // The clock's thread.
  private void tick() {
    guard.run(() -> {
      // StarL never interrupts this thread: another interrupt is a request to end it.
      while (!isClosed && !Thread.currentThread().isInterrupted()) {
        robot.advance(clock.nowNs());
        guard.await(() -> isClosed, robot.dueNs() - clock.nowNs());
      }
    });
  }

  // The server's thread.
  private void accept(ServerSocket from) {
    while (!from.isClosed()) {
      try {
        Socket socket = from.accept();
        talk(SocketLink.of(socket));
      } catch (IOException e) {
        if (!from.isClosed()) {
          onLinkEnd.accept(e);
        }
      }
    }
  }

  // The line's thread.
  private void talk(ByteLink newLink) {
    WriteQueue queue = new WriteQueue(QUEUE_BYTES);
    try {
      OutputStream output = newLink.output();
      if (!replaceLink(newLink, queue)) {
        return;
      }
      thread("writer", () -> queue.writeTo(output, newLink)).start();
      byte[] buffer = new byte[256];
      for (int n = newLink.input().read(buffer); n >= 0; n = newLink.input().read(buffer)) {
        int length = n;
        inspect(create -> create.receive(buffer, length, clock.nowNs()));
      }
      onLinkEnd.accept(new IOException(newLink + " was closed"));
    } catch (IOException e) {
      onLinkEnd.accept(e);
    } finally {
      queue.close();
      WriteQueue.closeQuietly(newLink);
    }
  }

  private boolean replaceLink(ByteLink newLink, WriteQueue newQueue) {
    return guard.get(() -> {
      if (!isClosed) {
        WriteQueue.closeQuietly(link);
        link = newLink;
        toDriver = newQueue;
      }
      return !isClosed;
    });
  }

  private Thread thread(String role, Runnable body) {
    return Daemons.of(name + " simulated create " + role, body);
  }
}
