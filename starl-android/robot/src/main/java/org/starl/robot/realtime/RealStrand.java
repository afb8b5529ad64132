package org.starl.robot.realtime;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.StrandClosed;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/**
 * A robot's strand in real time. Its threads are daemons: whoever makes a strand waits for the
 * robot's end, and closes the strand.
 *
 * <p>An exception of a piece or of the app is a bug: it goes to the handler given here, on the
 * strand's thread, and the strand is closed.
 */
public final class RealStrand implements Strand, Timers, AutoCloseable {

  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(10);

  private final String name;
  private final Clock clock;
  private final Consumer<Throwable> onError;
  private final Thread thread;
  private final ReentrantLock lock = new ReentrantLock();

  // Guarded by the lock.
  private final Condition changed = lock.newCondition();
  private final AlarmHeap alarms = new AlarmHeap();
  private boolean isClosed;
  private final StrandTally tally = new StrandTally();

  private volatile @Nullable RealApp app;
  private volatile long pieceNs;

  /**
   * A strand that runs from now on.
   *
   * @param name of the robot; its threads bear it
   * @param onError takes what comes out of a piece or of the app
   */
  public RealStrand(String name, Clock clock, Consumer<Throwable> onError) {
    this.name = name;
    this.clock = clock;
    this.onError = onError;
    this.pieceNs = clock.nowNs();
    this.thread = new Thread(this::loop, name + " strand");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void post(Runnable action) {
    lock.lock();
    try {
      set(new Posted(action), clock.nowNs());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public Timer timer(Runnable action) {
    return new RealTimer(this, action);
  }

  @Override
  public void start(Runnable body) {
    RealApp newApp = new RealApp(this, lock, name + " app", body);
    lock.lock();
    try {
      if (app != null) {
        throw new IllegalStateException(name + ": an app was started here before");
      }
      app = newApp;
      newApp.start();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public boolean isCurrent() {
    Thread caller = Thread.currentThread();
    RealApp mine = app;
    return caller == thread || (mine != null && mine.isOn(caller));
  }

  @Override
  public void sleepUntil(long atNs) {
    runningApp().sleepUntil(atNs);
  }

  /** {@inheritDoc} At the deadline the condition is evaluated once more. */
  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    return runningApp().awaitUntil(condition, deadlineNs);
  }

  /**
   * Ends the strand: no further piece begins, and the app is unwound by {@link StrandClosed}. Called
   * from outside, it returns when that is done, or tells the error handler that it was not done in
   * time; called on the strand, it is done after the piece that calls it.
   */
  @Override
  public void close() {
    closeSoon();
    if (isCurrent()) {
      return;
    }
    try {
      thread.join(CLOSE_LIMIT.toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (thread.isAlive()) {
      onError.accept(overdue());
    }
  }

  /**
   * A clock for the strand alone that stands still while a piece runs, at the time at which it began:
   * all that lies between two waits happens at one time, as in the simulator.
   */
  public Clock pieceClock() {
    return () -> pieceNs;
  }

  public boolean isClosed() {
    lock.lock();
    try {
      return isClosed;
    } finally {
      lock.unlock();
    }
  }

  /** How the strand's time was used so far. From any thread. */
  public StrandUse use() {
    lock.lock();
    try {
      return tally.use();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public String toString() {
    return name;
  }

  long nowNs() {
    return clock.nowNs();
  }

  /** A piece begins, at the time returned. */
  long beginPiece() {
    long nowNs = clock.nowNs();
    pieceNs = nowNs;
    return nowNs;
  }

  /** Sets an alarm, anew if it is set; a closed strand has none. */
  void set(Alarm alarm, long atNs) {
    lock.lock();
    try {
      if (!isClosed) {
        alarms.remove(alarm);
        alarms.add(alarm, Math.max(atNs, clock.nowNs()));
        changed.signal();
      }
    } finally {
      lock.unlock();
    }
  }

  void cancel(Alarm alarm) {
    lock.lock();
    try {
      alarms.remove(alarm);
    } finally {
      lock.unlock();
    }
  }

  boolean isSet(Alarm alarm) {
    lock.lock();
    try {
      return alarm.index != Alarm.NOWHERE;
    } finally {
      lock.unlock();
    }
  }

  /** Adds a piece, and whose it was, to the strand's use. */
  void account(long startNs, String by) {
    long pieceNs = clock.nowNs() - startNs;
    lock.lock();
    try {
      tally.add(pieceNs, by);
    } finally {
      lock.unlock();
    }
  }

  private void loop() {
    for (Alarm due = awaitDue(); due != null; due = awaitDue()) {
      try {
        run(due);
      } catch (Throwable e) {
        closeSoon();
        onError.accept(e);
      }
    }
    RealApp left = app;
    if (left != null) {
      try {
        left.unwind();
      } catch (Throwable e) {
        onError.accept(e);
      }
    }
  }

  private void run(Alarm due) throws Throwable {
    RealApp before = app;
    if (before != null && before.isWake(due)) {
      due.ring();
      return;
    }
    long startNs = beginPiece();
    try {
      due.ring();
    } finally {
      account(startNs, due instanceof RealTimer ? "a timer" : "a message or an event");
    }
    RealApp after = app;
    if (after != null && !isClosed()) {
      after.afterPiece();
    }
  }

  /** Waits for the next alarm, and takes it out; null when the strand is closed. */
  private @Nullable Alarm awaitDue() {
    lock.lock();
    try {
      while (!isClosed) {
        Alarm first = alarms.first();
        long restNs = first == null ? Long.MAX_VALUE : first.atNs - clock.nowNs();
        if (first != null && restNs <= 0) {
          alarms.remove(first);
          return first;
        }
        changed.await(restNs, TimeUnit.NANOSECONDS);
      }
      return null;
    } catch (InterruptedException e) {
      // Nobody but a stranger interrupts this thread, and means that it shall end.
      closeSoon();
      Thread.currentThread().interrupt();
      return null;
    } finally {
      lock.unlock();
    }
  }

  private void closeSoon() {
    lock.lock();
    try {
      isClosed = true;
      alarms.clear();
      changed.signal();
    } finally {
      lock.unlock();
    }
  }

  private IllegalStateException overdue() {
    RealApp mine = app;
    Thread busy = mine != null && mine.hasBaton() ? mine.thread() : thread;
    IllegalStateException late =
        new IllegalStateException(
            busy.getName() + " has not ended " + CLOSE_LIMIT.getSeconds() + " s after its close");
    late.setStackTrace(busy.getStackTrace());
    return late;
  }

  private RealApp runningApp() {
    RealApp mine = app;
    if (mine == null || !mine.isOn(Thread.currentThread())) {
      throw new IllegalStateException(
          name + ": only the app may wait; a handler, a timer or a condition runs to its end");
    }
    return mine;
  }

  /** An action that is due at once. */
  private static final class Posted extends Alarm {
    private final Runnable action;

    Posted(Runnable action) {
      this.action = action;
    }

    @Override
    void ring() {
      action.run();
    }
  }
}
