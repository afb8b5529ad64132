package org.starl.robot.create;

import java.io.IOException;
import java.io.OutputStream;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.robot.realtime.Daemons;

/**
 * Runs a {@link SimulatedCreate} in real time at the far end of a link: hardware in the loop without
 * the hardware. The robot outlives a link, as a real one does, and continues its last command.
 */
public final class CreateHost implements AutoCloseable {

  /** Capacity for a driver that does not read; a serial line loses the rest. */
  private static final int OUTBOX_BYTES = 4096;

  private final String name;
  private final Clock clock;
  private final Consumer<IOException> onLinkEnd;
  private final ReentrantLock lock = new ReentrantLock();
  private final Thread ticker;

  // Guarded by the lock.
  private final Condition closing = lock.newCondition();
  private final SimulatedCreate robot;
  private WriteQueue outbox = new WriteQueue(OUTBOX_BYTES);
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
    robot = new SimulatedCreate(model, body, bytes -> outbox.offer(bytes));
    ticker = thread("clock", this::tick);
  }

  /**
   * Switches a robot on, until {@link #close}.
   *
   * @param name of the threads
   * @param body is called on threads of this host, one at a time
   * @param onLinkEnd takes the reason why each link ended, on a thread of this host
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
    lock.lock();
    try {
      server = newServer;
    } finally {
      lock.unlock();
    }
    thread("server", () -> accept(newServer)).start();
  }

  /** Runs {@code inspector} with exclusive access to the robot. */
  public void inspect(Consumer<SimulatedCreate> inspector) {
    lock.lock();
    try {
      inspector.accept(robot);
    } finally {
      lock.unlock();
    }
  }

  /** Switches the robot off, and ends its link. */
  @Override
  public void close() {
    lock.lock();
    try {
      isClosed = true;
      closing.signalAll();
      outbox.close();
      WriteQueue.closeQuietly(link);
      WriteQueue.closeQuietly(server);
    } finally {
      lock.unlock();
    }
  }

  // The clock's thread.
  private void tick() {
    lock.lock();
    try {
      while (!isClosed) {
        robot.advance(clock.nowNs());
        long leftNs = robot.dueNs() - clock.nowNs();
        while (!isClosed && leftNs > 0) {
          leftNs = closing.awaitNanos(leftNs);
        }
      }
    } catch (InterruptedException e) {
      // StarL never interrupts this thread: another interrupt is a request to end it.
      Thread.currentThread().interrupt();
    } finally {
      lock.unlock();
    }
  }

  // The server's thread.
  private void accept(ServerSocket from) {
    while (!from.isClosed()) {
      try {
        Socket socket = from.accept();
        talk(new SocketLink(socket));
      } catch (IOException e) {
        if (!from.isClosed()) {
          onLinkEnd.accept(e);
        }
      }
    }
  }

  // The line's thread.
  private void talk(ByteLink mine) {
    WriteQueue toMine = new WriteQueue(OUTBOX_BYTES);
    try {
      OutputStream output = mine.output();
      if (!replaceLink(mine, toMine)) {
        return;
      }
      thread("voice", () -> toMine.writeTo(output, mine)).start();
      byte[] buffer = new byte[256];
      for (int n = mine.input().read(buffer); n >= 0; n = mine.input().read(buffer)) {
        int length = n;
        inspect(create -> create.receive(buffer, length, clock.nowNs()));
      }
      onLinkEnd.accept(new IOException(mine + " was closed"));
    } catch (IOException e) {
      onLinkEnd.accept(e);
    } finally {
      toMine.close();
      WriteQueue.closeQuietly(mine);
    }
  }

  private boolean replaceLink(ByteLink newLink, WriteQueue newOutbox) {
    lock.lock();
    try {
      if (isClosed) {
        return false;
      }
      WriteQueue.closeQuietly(link);
      link = newLink;
      outbox = newOutbox;
      return true;
    } finally {
      lock.unlock();
    }
  }

  private Thread thread(String role, Runnable body) {
    return Daemons.of(name + " simulated create " + role, body);
  }
}
