package org.starl.sim.kernel;

import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;

/**
 * The app of a strand. It runs on its carrier from one wait to the next, as one piece of the
 * strand; an app that suspends has no carrier, and runs on the kernel's thread. The object itself is the event that resumes the app: at its start, after a sleep, or at
 * the deadline of an await.
 */
final class WaitingApp implements Prefetchable {

  /** The number of further waits after the end of the run before the app is given up. */
  private static final int MAX_REFUSALS = 1000;

  /** The limit of awaits that return at once, in one action. */
  static final int MAX_AWAITS = 100_000;

  private final Kernel kernel;
  private final SimStrand strand;
  // One of the two, until it has ended.
  private @Nullable Runnable body;
  private @Nullable SuspendedApp suspended;
  // From its start to its end.
  private @Nullable Carrier carrier;
  private @Nullable Object continuation;
  private boolean isRunning;
  private boolean isLost;
  private int refusals;
  private int awaits;
  private @Nullable Throwable failure;

  // The pending wait: an event of the queue, a condition stored in the strand, or both.
  private int wakeSlot = EventTable.NONE;
  private long suspendedNs;
  private boolean conditionHeld;

  WaitingApp(Kernel kernel, SimStrand strand, Runnable body) {
    this.kernel = kernel;
    this.strand = strand;
    this.body = body;
  }

  WaitingApp(Kernel kernel, SimStrand strand, SuspendedApp suspended) {
    this.kernel = kernel;
    this.strand = strand;
    this.suspended = suspended;
  }

  void start() {
    if (!strand.isClosed()) {
      wakeSlot = kernel.add(kernel.nowNs(), strand, this);
    }
  }

  @Override
  public int prefetch() {
    Carrier waiting = carrier;
    return waiting == null
        ? Cache.prefetch(continuation) + Cache.prefetch(suspended)
        : waiting.touch();
  }

  /** Whether the app itself runs on the strand now. */
  boolean isRunning() {
    return isRunning;
  }

  /** Whether it is an app without a thread. */
  boolean isSuspended() {
    return suspended != null;
  }

  /** The app's thread while the app runs, or null; for a watch on another thread. */
  @Nullable Thread runningThread() {
    Carrier mine = carrier;
    return isRunning && mine != null ? mine.thread() : null;
  }

  /** Where the app waits or runs; empty if it has not started or has ended. */
  StackTraceElement[] stack() {
    SuspendedApp threadless = suspended;
    Object waiting = continuation;
    if (threadless != null && waiting != null) {
      return isRunning ? Thread.currentThread().getStackTrace() : threadless.stack(waiting);
    }
    Carrier mine = carrier;
    return mine == null ? new StackTraceElement[0] : mine.thread().getStackTrace();
  }

  /** When its last wait began. */
  long suspendedNs() {
    return suspendedNs;
  }

  void sleepUntil(long atNs) {
    suspend(null, atNs, true);
  }

  boolean awaitUntil(BooleanSupplier newCondition, long deadlineNs) {
    if (holdsAtOnce(newCondition)) {
      return true;
    }
    suspend(newCondition, deadlineNs, deadlineNs != Long.MAX_VALUE);
    return conditionHeld;
  }

  /** Begins a wait, and returns at once; returns whether the condition holds already. */
  boolean suspendUntil(
      @Nullable BooleanSupplier newCondition, long deadlineNs, Object newContinuation) {
    if (newCondition != null && holdsAtOnce(newCondition)) {
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

  private boolean holdsAtOnce(BooleanSupplier newCondition) {
    if (strand.isClosed() || !newCondition.getAsBoolean()) {
      return false;
    }
    awaits++;
    if (awaits > MAX_AWAITS) {
      throw Stalled.awaits(MAX_AWAITS);
    }
    return true;
  }

  /**
   * Resumes the app if its condition holds after {@code piece} has run.
   *
   * @return the exception of the app, or null
   */
  @Nullable Throwable afterPiece(Runnable piece) {
    BooleanSupplier awaited = strand.awaited;
    if (awaited != null && piece != this && awaited.getAsBoolean()) {
      forgetWait();
      conditionHeld = true;
      resume();
    }
    return failure;
  }

  /** Cancels the pending wait: no event of the queue resumes the app. */
  void forgetWait() {
    strand.awaited = null;
    if (wakeSlot != EventTable.NONE) {
      kernel.queue.remove(wakeSlot);
      wakeSlot = EventTable.NONE;
    }
  }

  /**
   * Resumes the app on its closed strand, where every wait throws, until it ends.
   *
   * @return the exception of the app while it unwinds, or null
   */
  @Nullable Throwable unwind() {
    Carrier waiting = carrier;
    if (waiting == null && continuation == null) {
      return null;
    }
    try {
      if (isLost && waiting != null) {
        runOn(waiting);
      }
      if (isBegun()) {
        resume();
      }
      return !isBegun()
          ? failure
          : new IllegalStateException(
              "the app goes on although its run has ended; does it catch StrandClosed?");
    } finally {
      end();
    }
  }

  @Override
  public void run() {
    wakeSlot = EventTable.NONE;
    BooleanSupplier awaited = strand.awaited;
    strand.awaited = null;
    conditionHeld = awaited != null && awaited.getAsBoolean();
    resume();
  }

  private void suspend(@Nullable BooleanSupplier newCondition, long untilNs, boolean isTimed) {
    Carrier mine = carrier;
    if (mine == null) {
      throw new IllegalStateException(strand + ": the app is over");
    }
    if (strand.isClosed()) {
      refuse();
      mine.suspend();
      throw new StrandClosed();
    }
    beginWait(newCondition, untilNs, isTimed);
    try {
      mine.suspend();
    } catch (NonKernelWait e) {
      forgetWait();
      throw e;
    }
    if (strand.isClosed()) {
      throw new StrandClosed();
    }
  }

  private void beginWait(@Nullable BooleanSupplier newCondition, long untilNs, boolean isTimed) {
    awaits = 0;
    suspendedNs = kernel.nowNs();
    strand.awaited = newCondition;
    if (isTimed) {
      wakeSlot = kernel.add(Math.max(untilNs, kernel.nowNs()), strand, this);
    }
  }

  /** Ends the app on its closed strand; returns if that has failed too often. */
  private void refuse() {
    refusals++;
    if (refusals <= MAX_REFUSALS) {
      throw new StrandClosed();
    }
  }

  private void resume() {
    Carrier mine = carrier;
    SuspendedApp threadless = suspended;
    if (threadless != null) {
      run(threadless);
      return;
    }
    if (mine == null) {
      mine = kernel.carry(strand, this::runBody);
      carrier = mine;
    }
    runOn(mine);
  }

  private boolean isBegun() {
    return carrier != null || continuation != null;
  }

  private void runOn(Carrier mine) {
    isRunning = true;
    try {
      if (isLost) {
        mine.recover();
        isLost = false;
      } else {
        mine.resume();
      }
    } catch (NonKernelWait e) {
      isLost = true;
      throw e;
    } finally {
      isRunning = false;
    }
    if (body == null) {
      end();
    }
  }

  private void run(SuspendedApp app) {
    if (continuation == null) {
      kernel.appBegins(strand);
    }
    boolean isOver = true;
    isRunning = true;
    try {
      isOver =
          app.resume(continuation, conditionHeld, strand.isClosed() ? new StrandClosed() : null);
    } catch (StrandClosed e) {
      failure = strand.isClosed() ? null : e;
    } catch (Throwable e) {
      failure = e;
    } finally {
      isRunning = false;
      if (isOver) {
        end();
      }
    }
  }

  // Runs on the carrier.
  private void runBody() {
    Runnable app = body;
    try {
      if (app != null) {
        app.run();
      }
    } catch (StrandClosed e) {
      failure = strand.isClosed() ? null : e;
    } catch (Throwable e) {
      failure = e;
    } finally {
      body = null;
    }
  }

  private void end() {
    carrier = null;
    suspended = null;
    continuation = null;
    kernel.appIsOver(strand);
  }
}
