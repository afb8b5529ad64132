package org.starl.robot.create;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.time.Time;

/**
 * Stands between a robot's program and its Create, in a process of its own. A Create has no watchdog:
 * when the driver's process is killed or frozen, the Create continues its last command. The guard has
 * the Create's link and passes bytes both ways. It stops the wheels when it is closed, which its
 * process does as soon as the driver's process is gone, and when the time of the driver's last command
 * is too long ago: a live driver repeats it. So a command that was held up on its way is not executed
 * late: older wheel speeds are dropped, and the wheels stop instead.
 *
 * <p>A guard that is killed, or that passes nothing for {@link #SILENT_MS}, is replaced by another one.
 * Before that the driver's own process stops the wheels ({@link #stopWheels}), because a process takes
 * long to start. All methods may be called from any thread.
 */
public final class WheelGuard implements AutoCloseable {

  /** A Create streams every 15 ms; after this time without frames the driver replaces its guard. */
  public static final long SILENT_MS = 500;

  private static final byte[] STOP = Commands.driveDirect(0, 0);

  /** Ends safe and full mode. */
  private static final byte[] PASSIVE = Commands.start();

  /** Sent repeatedly: a truncated command before it may swallow one. */
  private static final int STOP_COPIES = 3;

  /** A live driver writes every 50 ms, and every 100 ms while it starts the robot. */
  private static final long MIN_VALID_MS = 150;

  private static final long MAX_VALID_MS = 300;

  /** Closing a port drops its unsent bytes; at 300 baud these take 600 ms. */
  private static final long DRAIN_MS = 700;

  private static final int BUFFER_BYTES = 256;

  private final ByteLink link;
  private final long validNs;
  private final ReentrantLock lock = new ReentrantLock();

  // Guarded by the lock.
  private final Condition changed = lock.newCondition();
  private boolean wheelsMayTurn;
  private boolean isHalted;
  private boolean isLinkOver;
  private long lastSentNs = Long.MIN_VALUE;

  private WheelGuard(ByteLink link, long validMs) {
    this.link = link;
    validNs = validMs * Time.NS_PER_MS;
  }

  /**
   * Guards the Create at the end of a link, until {@link #close}.
   *
   * @param validMs for how many ms a command is executed: see {@link #validMs}
   */
  public static WheelGuard start(ByteLink link, long validMs) {
    WheelGuard guard = new WheelGuard(link, validMs);
    Daemons.of("wheel guard", guard::watch).start();
    return guard;
  }

  /** For how many ms a guard executes a command: the reaction time, from 150 to 300 ms. */
  public static long validMs(long reactionMs) {
    return Math.min(MAX_VALID_MS, Math.max(MIN_VALID_MS, reactionMs));
  }

  /**
   * Stops the wheels in place of a guard that was killed, over a link of its own.
   *
   * @throws IOException if there is no link: the wheels may turn
   */
  public static void stopWheels(ByteLink.Source port) throws IOException {
    try (ByteLink link = port.open()) {
      for (int i = 0; i < STOP_COPIES; i++) {
        link.output().write(STOP);
      }
      link.output().flush();
    }
  }

  /**
   * Passes bytes of the program to the Create; wheel speeds only if they are not too old. A link that
   * fails is closed, which ends {@link #passToProgram}.
   *
   * @param sentNs when the program wrote them, by {@link RealClock#machineNs}
   * @param bytes of one write
   */
  public void pass(long sentNs, byte[] bytes) {
    lock.lock();
    try {
      boolean isValid = RealClock.machineNs() - sentNs < validNs;
      if (isHalted) {
        return;
      }
      if (!isValid && bytes.length == STOP.length && Commands.areWheelSpeeds(bytes)) {
        stop();
        return;
      }
      link.output().write(bytes);
      link.output().flush();
      if (isValid) {
        lastSentNs = Math.max(lastSentNs, sentNs);
        wheelsMayTurn = true;
        changed.signalAll();
      }
    } catch (IOException e) {
      WriteQueue.closeQuietly(link);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Passes bytes of the Create to the program until one of the two is gone.
   *
   * @return why it has ended, for people
   */
  public String passToProgram(OutputStream program) {
    byte[] buffer = new byte[BUFFER_BYTES];
    try {
      InputStream from = link.input();
      for (int n = from.read(buffer); n >= 0; n = from.read(buffer)) {
        if (!isTaken(program, buffer, n)) {
          return "the robot's program has ended";
        }
      }
      linkOver();
      return link + " was closed";
    } catch (IOException e) {
      linkOver();
      return link + ": " + e.getMessage();
    }
  }

  private static boolean isTaken(OutputStream program, byte[] bytes, int length) {
    try {
      program.write(bytes, 0, length);
      program.flush();
      return true;
    } catch (IOException e) {
      return false; // the program is gone
    }
  }

  private void linkOver() {
    lock.lock();
    try {
      isLinkOver = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Stops the wheels of a silent program; its later bytes are passed on again. */
  private void watch() {
    lock.lock();
    try {
      while (!isHalted) {
        long leftNs = lastSentNs + validNs - RealClock.machineNs();
        if (!wheelsMayTurn) {
          changed.await();
        } else if (leftNs > 0) {
          changed.awaitNanos(leftNs);
        } else {
          stop();
        }
      }
    } catch (InterruptedException e) {
      // StarL never interrupts this thread: an interrupt is a request to end it.
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      WriteQueue.closeQuietly(link);
    } finally {
      lock.unlock();
    }
  }

  // With the lock held.
  private void stop() throws IOException {
    if (wheelsMayTurn) {
      link.output().write(STOP);
      link.output().flush();
      wheelsMayTurn = false;
    }
  }

  /**
   * Stops the wheels for good, leaves the Create in passive mode, and closes the link when the bytes
   * are sent.
   */
  @Override
  public void close() {
    try {
      // A thread that holds the lock longer waits for a stuck line: stopping is impossible.
      if (lock.tryLock(DRAIN_MS, TimeUnit.MILLISECONDS)) {
        try {
          halt();
        } finally {
          lock.unlock();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    WriteQueue.closeQuietly(link);
  }

  // With the lock held.
  private void halt() throws InterruptedException {
    if (!isHalted) {
      isHalted = true;
      wheelsMayTurn = false;
      changed.signalAll();
      try {
        for (int i = 0; i < STOP_COPIES; i++) {
          link.output().write(STOP);
          link.output().write(PASSIVE);
          link.output().flush();
        }
      } catch (IOException e) {
        isLinkOver = true;
      }
    }
    long leftNs = DRAIN_MS * Time.NS_PER_MS;
    while (!isLinkOver && leftNs > 0) {
      leftNs = changed.awaitNanos(leftNs);
    }
  }
}
