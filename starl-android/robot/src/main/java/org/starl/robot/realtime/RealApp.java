package org.starl.robot.realtime;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;

/**
 * A strand's app: a thread that runs while it has the baton. The strand's own thread passes it, and
 * waits until it is back. An app that suspends has no thread of its own: the strand's runs it.
 */
final class RealApp {

  /** Number of times that an app may wait again after its end was requested. */
  private static final int MAX_REFUSALS = 1000;

  private final RealStrand strand;
  private final ReentrantLock lock;
  private final Condition batonPassed;
  private final Thread thread;
  private final @Nullable SuspendedApp suspended;
  private final Wake wake = new Wake();
  private boolean hasBaton;

  // Accessed only with the baton; the lock that passes the baton makes it visible.
  private boolean isStarted;
  private boolean isOver;
  private int refusals;
  private @Nullable Throwable failure;
  private @Nullable BooleanSupplier condition;
  private boolean conditionHeld;
  private volatile @Nullable Object continuation;

  RealApp(RealStrand strand, ReentrantLock lock, String name, Runnable body) {
    this.strand = strand;
    this.lock = lock;
    this.batonPassed = lock.newCondition();
    this.thread = Daemons.of(name, () -> run(body));
    this.suspended = null;
  }

  RealApp(RealStrand strand, ReentrantLock lock, Thread thread, SuspendedApp suspended) {
    this.strand = strand;
    this.lock = lock;
    this.batonPassed = lock.newCondition();
    this.thread = thread;
    this.suspended = suspended;
  }

  Thread thread() {
    return thread;
  }

  /** Where it waits or runs. From any thread. */
  StackTraceElement[] stack() {
    SuspendedApp threadless = suspended;
    Object waiting = continuation;
    return threadless == null || waiting == null || hasBaton()
        ? thread.getStackTrace()
        : threadless.stack(waiting);
  }

  boolean isOn(Thread other) {
    return thread == other && (suspended == null || hasBaton);
  }

  boolean isSuspended() {
    return suspended != null;
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

  /** Begins a wait, and returns at once; returns whether the condition holds already. */
  boolean suspendUntil(
      @Nullable BooleanSupplier newCondition, long deadlineNs, Object newContinuation) {
    if (newCondition != null && !strand.isClosed() && newCondition.getAsBoolean()) {
      return true;
    }
    continuation = newContinuation;
    if (strand.isClosed()) {
      refuse();
    } else {
      beginWait(newCondition, deadlineNs, newCondition == null || deadlineNs != Long.MAX_VALUE);
    }
    return false;
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
    if (suspended == null) {
      lendBaton();
    } else {
      run(suspended);
    }
    strand.account(startNs, "the app");
    Throwable thrown = failure;
    if (thrown != null) {
      failure = null;
      throw thrown;
    }
  }

  private void lendBaton() {
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
  }

  private void beginWait(@Nullable BooleanSupplier newCondition, long untilNs, boolean isTimed) {
    condition = newCondition;
    if (isTimed) {
      strand.set(wake, untilNs);
    }
  }

  private void suspend(@Nullable BooleanSupplier newCondition, long untilNs, boolean isTimed) {
    if (strand.isClosed()) {
      refuse();
      setBaton(false);
      awaitBaton();
      throw new StrandClosed();
    }
    beginWait(newCondition, untilNs, isTimed);
    setBaton(false);
    awaitBaton();
    if (strand.isClosed()) {
      throw new StrandClosed();
    }
  }

  /** Ends the app on its closed strand; returns if that has failed too often. */
  private void refuse() {
    refusals++;
    if (refusals <= MAX_REFUSALS) {
      throw new StrandClosed();
    }
  }

  private void setBaton(boolean isApps) {
    lock.lock();
    try {
      hasBaton = isApps;
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

  // On the strand's thread.
  private void run(SuspendedApp app) {
    isStarted = true;
    boolean ends = true;
    setBaton(true);
    try {
      ends = app.resume(continuation, conditionHeld, strand.isClosed() ? new StrandClosed() : null);
    } catch (StrandClosed e) {
      failure = strand.isClosed() ? null : e;
    } catch (Throwable e) {
      failure = e;
    } finally {
      isOver = ends;
      setBaton(false);
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
      setBaton(false);
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
