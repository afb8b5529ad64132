package org.starl.robot.realtime;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StrandClosed;

/**
 * A strand's app: a thread that runs while it has the baton. The strand's own thread passes it, and
 * waits until it is back.
 */
final class RealApp {

  /** Number of times that an app may wait again after its end was requested. */
  private static final int MAX_REFUSALS = 1000;

  private final RealStrand strand;
  private final ReentrantLock lock;
  private final Condition batonPassed;
  private final Thread thread;
  private final Wake wake = new Wake();
  private boolean hasBaton;

  // Accessed only with the baton; the lock that passes the baton makes it visible.
  private boolean isStarted;
  private boolean isOver;
  private int refusals;
  private @Nullable Throwable failure;
  private @Nullable BooleanSupplier condition;
  private boolean conditionHeld;

  RealApp(RealStrand strand, ReentrantLock lock, String name, Runnable body) {
    this.strand = strand;
    this.lock = lock;
    this.batonPassed = lock.newCondition();
    this.thread = Daemons.of(name, () -> run(body));
  }

  Thread thread() {
    return thread;
  }

  boolean isOn(Thread other) {
    return thread == other;
  }

  boolean hasBaton() {
    lock.lock();
    try {
      return hasBaton;
    } finally {
      lock.unlock();
    }
  }

  void start() {
    strand.set(wake, strand.nowNs());
  }

  void sleepUntil(long atNs) {
    suspend(null, atNs, true);
  }

  boolean awaitUntil(BooleanSupplier newCondition, long deadlineNs) {
    if (!strand.isClosed() && newCondition.getAsBoolean()) {
      return true;
    }
    suspend(newCondition, deadlineNs, deadlineNs != Long.MAX_VALUE);
    return conditionHeld;
  }

  /** On the strand's thread: resumes the app if the condition that it waits for holds. */
  void afterPiece() throws Throwable {
    BooleanSupplier awaited = condition;
    if (awaited != null && awaited.getAsBoolean()) {
      strand.cancel(wake);
      condition = null;
      conditionHeld = true;
      resume();
    }
  }

  /** On the strand's thread, the strand being closed: makes the app end. */
  void unwind() throws Throwable {
    condition = null;
    if (!isStarted || isOver) {
      return;
    }
    resume();
    if (!isOver) {
      throw new IllegalStateException(
          strand + ": the app goes on although its run has ended; does it catch StrandClosed?");
    }
  }

  private void resume() throws Throwable {
    long startNs = strand.beginPiece();
    lock.lock();
    try {
      hasBaton = true;
      if (isStarted) {
        batonPassed.signal();
      } else {
        isStarted = true;
        thread.start();
      }
      while (hasBaton) {
        batonPassed.awaitUninterruptibly();
      }
    } finally {
      lock.unlock();
    }
    strand.account(startNs, "the app");
    Throwable thrown = failure;
    if (thrown != null) {
      failure = null;
      throw thrown;
    }
  }

  private void suspend(@Nullable BooleanSupplier newCondition, long untilNs, boolean isTimed) {
    if (strand.isClosed()) {
      refuse();
    }
    condition = newCondition;
    if (isTimed) {
      strand.set(wake, untilNs);
    }
    passBaton();
    awaitBaton();
    if (strand.isClosed()) {
      throw new StrandClosed();
    }
  }

  private void refuse() {
    refusals++;
    if (refusals > MAX_REFUSALS) {
      passBaton();
      awaitBaton();
    }
    throw new StrandClosed();
  }

  private void passBaton() {
    lock.lock();
    try {
      hasBaton = false;
      batonPassed.signal();
    } finally {
      lock.unlock();
    }
  }

  private void awaitBaton() {
    lock.lock();
    try {
      while (!hasBaton) {
        batonPassed.awaitUninterruptibly();
      }
    } finally {
      lock.unlock();
    }
  }

  // On the app's thread.
  private void run(Runnable body) {
    try {
      body.run();
    } catch (StrandClosed e) {
      failure = strand.isClosed() ? null : e;
    } catch (Throwable e) {
      failure = e;
    } finally {
      isOver = true;
      passBaton();
    }
  }

  /** The end of a sleep, the deadline of an await, or the app's start. */
  private final class Wake extends Alarm {

    @Override
    void ring() throws Throwable {
      BooleanSupplier awaited = condition;
      condition = null;
      conditionHeld = awaited != null && awaited.getAsBoolean();
      resume();
    }
  }
}
