package org.starl.robot.realtime;

import java.time.Duration;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/**
 * A robot's strand in real time. Its threads are daemons: the owner of a strand waits for the robot's
 * end and closes the strand.
 *
 * <p>An exception in a piece or in the app is a bug: the handler given here gets it on the strand's
 * thread, and the strand is closed.
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
  private final TreeSet<Alarm> alarms = new TreeSet<>();
  private long lastNumber;
  private final StrandTally tally = new StrandTally();

  // Written with the lock held.
  private volatile boolean isClosed;

  private volatile @Nullable RealApp app;
  private volatile long pieceNs;

  // Set once; then the strand only.
  private volatile long longNs = Long.MAX_VALUE;
  private volatile LongPieces onLongPiece = (ns, by) -> {};

  /**
   * A strand that runs from now on.
   *
   * @param name of the robot, for its threads' names
   * @param onError takes an exception of a piece or of the app
   */
  public RealStrand(String name, Clock clock, Consumer<Throwable> onError) {
    this.name = name;
    this.clock = clock;
    this.onError = onError;
    this.pieceNs = clock.nowNs();
    this.thread = Daemons.of(name + " strand", this::loop);
    thread.start();
  }

  /** Receives long pieces. */
  @FunctionalInterface
  public interface LongPieces {

    /**
     * A piece has ended.
     *
     * @param pieceNs its length
     * @param by its origin, as in {@link StrandUse}
     */
    void ended(long pieceNs, String by);
  }

  /**
   * Reports pieces over {@code limitNs}, on the strand; each must be over twice as long as the one
   * that was reported before, so there are few.
   */
  public void onLongPiece(long limitNs, LongPieces receiver) {
    onLongPiece = receiver;
    longNs = limitNs;
  }

  @Override
  public void post(Runnable action) {
    set(new Piece(action, "a message or an event"), callNs());
  }

  @Override
  public Timer timer(Runnable action) {
    return new Piece(action, "a timer");
  }

  @Override
  public void start(Runnable body) {
    start(new RealApp(this, lock, name + " app", body));
  }

  @Override
  public void start(SuspendedApp body) {
    start(new RealApp(this, lock, thread, body));
  }

  private void start(RealApp newApp) {
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
    blockingApp().sleepUntil(atNs);
  }

  /** {@inheritDoc} At the deadline the condition is evaluated once more. */
  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    return blockingApp().awaitUntil(condition, deadlineNs);
  }

  @Override
  public boolean suspendUntil(
      @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
    RealApp mine = runningApp();
    if (!mine.isSuspended()) {
      throw new IllegalStateException(name + ": only an app without a thread may suspend");
    }
    return mine.suspendUntil(condition, deadlineNs, continuation);
  }

  /**
   * Ends the strand: no further piece begins, and the app is unwound by {@link StrandClosed}. Called
   * from outside, it returns when that is done, or reports a timeout to the error handler; called on
   * the strand, it takes effect after the calling piece.
   */
  @Override
  public void close() {
    closeSoon();
    if (isCurrent()) {
      return;
    }
    Daemons.join(thread, CLOSE_LIMIT.toMillis());
    if (thread.isAlive()) {
      onError.accept(overdue());
    }
  }

  /**
   * A clock for the strand only: while a piece runs, it shows the time at which the piece started. So
   * everything between two waits happens at one time, as in the simulator.
   */
  public Clock pieceClock() {
    return () -> pieceNs;
  }

  public boolean isClosed() {
    return isClosed;
  }

  /** The stack of the app's thread; empty if there is none. From any thread. */
  public StackTraceElement[] appStack() {
    RealApp mine = app;
    return mine == null ? new StackTraceElement[0] : mine.stack();
  }

  /** The use of the strand's time so far. From any thread. */
  public StrandUse use() {
    return lockedGet(tally::use);
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

  /** Sets an alarm, as {@link Timer#set} does; a closed strand sets none. */
  void set(Alarm alarm, long atNs) {
    withLock(() -> {
      boolean isSetSo = alarm.atNs == atNs && alarms.contains(alarm);
      if (!isClosed && !isSetSo) {
        alarms.remove(alarm);
        alarm.atNs = Math.max(atNs, callNs());
        alarm.number = ++lastNumber;
        alarms.add(alarm);
        changed.signal();
      }
    });
  }

  // A piece happens at one time: what a slow one sets is ordered as what a fast one sets.
  private long callNs() {
    return isCurrent() ? pieceNs : clock.nowNs();
  }

  void cancel(Alarm alarm) {
    withLock(() -> alarms.remove(alarm));
  }

  /** Adds a piece and its origin to the strand's use. */
  void account(long startNs, String by) {
    long pieceNs = clock.nowNs() - startNs;
    withLock(() -> tally.add(pieceNs, by));
    if (pieceNs > longNs) {
      longNs = 2 * pieceNs;
      onLongPiece.ended(pieceNs, by);
    }
  }

  private void withLock(Runnable work) {
    lock.lock();
    try {
      work.run();
    } finally {
      lock.unlock();
    }
  }

  private <T> T lockedGet(Supplier<T> value) {
    lock.lock();
    try {
      return value.get();
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
    RealApp last = app;
    if (last != null) {
      try {
        last.unwind();
      } catch (Throwable e) {
        onError.accept(e);
      }
    }
  }

  private void run(Alarm due) throws Throwable {
    if (!(due instanceof Piece piece)) {
      due.ring();
      return;
    }
    long startNs = beginPiece();
    try {
      piece.ring();
    } finally {
      account(startNs, piece.origin);
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
        if (alarms.isEmpty()) {
          changed.await();
          continue;
        }
        Alarm first = alarms.first();
        long restNs = first.atNs - clock.nowNs();
        if (restNs <= 0) {
          alarms.remove(first);
          return first;
        }
        changed.await(restNs, TimeUnit.NANOSECONDS);
      }
      return null;
    } catch (InterruptedException e) {
      // StarL never interrupts this thread: another interrupt is a request to end it.
      closeSoon();
      Thread.currentThread().interrupt();
      return null;
    } finally {
      lock.unlock();
    }
  }

  private void closeSoon() {
    withLock(() -> {
      isClosed = true;
      alarms.clear();
      changed.signal();
    });
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

  private RealApp blockingApp() {
    RealApp mine = runningApp();
    if (mine.isSuspended()) {
      throw SuspendedApp.blockingCall(this);
    }
    return mine;
  }

  private RealApp runningApp() {
    RealApp mine = app;
    if (mine == null || !mine.isOn(Thread.currentThread())) {
      throw new IllegalStateException(
          name + ": only the app may wait; a handler, a timer or a condition runs to its end");
    }
    return mine;
  }

  /** A posted action, or a timer. */
  private final class Piece extends Alarm implements Timer {
    private final Runnable action;
    private final String origin;

    /** @param origin for {@link StrandUse} */
    Piece(Runnable action, String origin) {
      this.action = action;
      this.origin = origin;
    }

    @Override
    public void set(long atNs) {
      if (atNs == NEVER) {
        cancel();
      } else {
        RealStrand.this.set(this, atNs);
      }
    }

    @Override
    public void cancel() {
      RealStrand.this.cancel(this);
    }

    @Override
    public boolean isSet() {
      return lockedGet(() -> alarms.contains(this));
    }

    @Override
    void ring() {
      action.run();
    }
  }
}
