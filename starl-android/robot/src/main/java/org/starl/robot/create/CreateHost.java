package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;

/**
 * Runs a {@link SimulatedCreate} in real time, at the far end of whatever link there is: hardware in
 * the loop without the hardware. The robot lives on when a link ends, as a real one does, and goes on
 * as it was told last.
 */
public final class CreateHost implements AutoCloseable {

  /** What waits for a driver that does not read; a serial line loses what is beyond. */
  private static final int OUTBOX_BYTES = 4096;

  private final String name;
  private final Clock clock;
  private final Consumer<IOException> onLinkEnd;
  private final ReentrantLock lock = new ReentrantLock();
  private final Thread ticker;

  // Guarded by the lock.
  private final Condition closing = lock.newCondition();
  private final SimulatedCreate robot;
  private Outbox outbox = new Outbox(OUTBOX_BYTES);
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
    robot = new SimulatedCreate(model, body, bytes -> outbox.offer(bytes, bytes.length));
    ticker = thread("clock", this::tick);
  }

  /**
   * Switches a robot on, until {@link #close}.
   *
   * @param name of the threads
   * @param body is called on threads of this host, by one at a time
   * @param onLinkEnd is told why each link ended, on a thread of this host
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

  /** Serves {@code link} from now on, in place of the one before. Returns at once. */
  public void serve(ByteLink newLink) {
    thread("line", () -> talk(newLink)).start();
  }

  /** Serves whoever connects to {@code newServer}, one after another; closes it at the end. */
  public void listen(ServerSocket newServer) {
    lock.lock();
    try {
      server = newServer;
    } finally {
      lock.unlock();
    }
    thread("server", () -> accept(newServer)).start();
  }

  /** Looks at the robot, or does something to it, while nobody else does. */
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
      closeQuietly(link);
      closeQuietly(server);
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
      // Nobody but a stranger interrupts this thread, and means that it shall end.
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
    Outbox toMine = new Outbox(OUTBOX_BYTES);
    try {
      OutputStream output = mine.output();
      if (!replaceLink(mine, toMine)) {
        return;
      }
      thread("voice", () -> say(toMine, output, mine)).start();
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
      closeQuietly(mine);
    }
  }

  private boolean replaceLink(ByteLink newLink, Outbox newOutbox) {
    lock.lock();
    try {
      if (isClosed) {
        return false;
      }
      closeQuietly(link);
      link = newLink;
      outbox = newOutbox;
      return true;
    } finally {
      lock.unlock();
    }
  }

  private static void say(Outbox from, OutputStream output, ByteLink mine) {
    byte[] buffer = new byte[OUTBOX_BYTES];
    try {
      for (int n = from.take(buffer); n > 0; n = from.take(buffer)) {
        output.write(buffer, 0, n);
        output.flush();
      }
    } catch (IOException e) {
      // Who reads from the link finds it closed, and tells.
      closeQuietly(mine);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      closeQuietly(mine);
    }
  }

  private Thread thread(String role, Runnable body) {
    Thread thread = new Thread(body, name + " simulated create " + role);
    thread.setDaemon(true);
    return thread;
  }

  // What cannot be closed is as good as closed: nobody uses it any more.
  private static void closeQuietly(@Nullable Closeable closeable) {
    if (closeable != null) {
      try {
        closeable.close();
      } catch (IOException ignored) {
        return;
      }
    }
  }
}
