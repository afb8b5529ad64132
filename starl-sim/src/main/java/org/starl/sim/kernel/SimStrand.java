package org.starl.sim.kernel;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Strand;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/** A robot's strand in virtual time: a piece takes no time, and no two pieces overlap. */
public final class SimStrand implements Strand, Timers {

  /** Limits the prefetched objects: a useless prefetch costs time and evicts other data. */
  private static final int MAX_PARTS = 32;

  private final Kernel kernel;
  private final String name;
  private boolean isClosed;
  private @Nullable WaitingApp app;

  /**
   * The condition that the app waits for, or null. Stored here because most pieces need no other
   * data of the app.
   */
  @Nullable BooleanSupplier awaited;

  private Object[] parts = {};

  SimStrand(Kernel kernel, String name) {
    this.kernel = kernel;
    this.name = name;
  }

  public String name() {
    return name;
  }

  @Override
  public void post(Runnable action) {
    kernel.schedule(kernel.nowNs(), this, action);
  }

  @Override
  public Timer timer(Runnable action) {
    return new KernelTimer(kernel, this, action);
  }

  @Override
  public boolean isCurrent() {
    return kernel.current() == this;
  }

  @Override
  public void start(Runnable newApp) {
    start(new WaitingApp(kernel, this, newApp));
  }

  @Override
  public void start(SuspendedApp newApp) {
    start(new WaitingApp(kernel, this, newApp));
  }

  private void start(WaitingApp newApp) {
    if (app != null) {
      throw new IllegalStateException(name + ": an app was started here before");
    }
    app = newApp;
    newApp.start();
  }

  @Override
  public void sleepUntil(long atNs) {
    blockingApp().sleepUntil(atNs);
  }

  /** {@inheritDoc} The condition is evaluated once more at the deadline. */
  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    return blockingApp().awaitUntil(condition, deadlineNs);
  }

  @Override
  public boolean suspendUntil(
      @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
    WaitingApp mine = runningApp();
    if (!mine.isSuspended()) {
      throw new IllegalStateException(name + ": only an app without a thread may suspend");
    }
    return mine.suspendUntil(condition, deadlineNs, continuation);
  }

  /**
   * Ends this strand after a crash or when the robot leaves: none of its pieces runs any more. Its
   * app is unwound by {@link StrandClosed}, {@code finally} blocks included: at once or, if a piece
   * of a strand calls this method, directly after that piece.
   *
   * @throws RobotError if the app is unwound at once, and fails or does not end
   */
  public void close() {
    if (isClosed) {
      return;
    }
    isClosed = true;
    if (app != null) {
      app.forgetWait();
      kernel.unwind(this);
    }
  }

  public boolean isClosed() {
    return isClosed;
  }

  @Override
  public String toString() {
    return name;
  }

  /** Runs one event of this strand, and then the app if its condition has become true. */
  void run(Runnable piece) {
    Throwable failure = null;
    kernel.setCurrent(this);
    try {
      piece.run();
      WaitingApp waiting = app;
      if (waiting != null && (piece == waiting || awaited != null)) {
        failure = waiting.afterPiece(piece);
      }
    } catch (Throwable e) {
      failure = e;
    } finally {
      kernel.setCurrent(null);
    }
    if (failure != null) {
      throw new RobotError(name, kernel.nowNs(), failure);
    }
  }

  /**
   * Adds small objects that most pieces of this strand use. The queue prefetches the first {@value
   * #MAX_PARTS} of them into the processor's cache before the strand's events run ({@link Cache}).
   * Has no other effect.
   */
  public void prefetch(Object... moreParts) {
    int more = Math.min(moreParts.length, MAX_PARTS - parts.length);
    Object[] all = Arrays.copyOf(parts, parts.length + more);
    System.arraycopy(moreParts, 0, all, parts.length, more);
    parts = all;
  }

  /** Prefetches the known objects that {@code piece} will use ({@link Cache}). */
  int touch(Runnable piece) {
    int read = touch();
    return piece instanceof Prefetchable touchable ? read + touchable.prefetch() : read;
  }

  /** Prefetches the known objects that any piece uses. */
  int touch() {
    int read = 0;
    for (Object part : parts) {
      read += Cache.prefetch(part);
    }
    return read;
  }

  /** Makes the app of this closed strand end. */
  void unwindApp() {
    if (app == null) {
      return;
    }
    Throwable failure;
    kernel.setCurrent(this);
    try {
      failure = app.unwind();
    } catch (Throwable e) {
      failure = e;
    } finally {
      kernel.setCurrent(null);
    }
    if (failure != null) {
      throw new RobotError(name, kernel.nowNs(), failure);
    }
  }

  /** The stack of the app where it waits or runs now; empty if there is none. */
  public StackTraceElement[] appStack() {
    return app == null ? new StackTraceElement[0] : app.stack();
  }

  /** Whether the app itself runs now, and does not wait. */
  public boolean isAppRunning() {
    return app != null && app.isRunning();
  }

  /** When the app's present wait began; 0 if it never waited. */
  public long appWaitsSinceNs() {
    return app == null ? 0 : app.suspendedNs();
  }

  /** The thread of the app while the app itself runs, or null. */
  @Nullable Thread runningAppThread() {
    return app == null ? null : app.runningThread();
  }

  private WaitingApp blockingApp() {
    WaitingApp mine = runningApp();
    if (mine.isSuspended()) {
      throw SuspendedApp.blockingCall(this);
    }
    return mine;
  }

  private WaitingApp runningApp() {
    if (app == null || !app.isRunning() || kernel.current() != this) {
      throw new IllegalStateException(
          name + ": only the app may wait; a handler, a timer or a condition runs to its end");
    }
    return app;
  }
}
