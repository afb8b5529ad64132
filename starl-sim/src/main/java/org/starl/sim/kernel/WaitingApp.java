package org.starl.sim.kernel;

import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.StrandClosed;

/**
 * The app of a strand. It runs on its carrier from one wait to the next, as one piece of the
 * strand. The object itself is the event that resumes the app: at its start, after a sleep, or at
 * the deadline of an await.
 */
final class WaitingApp implements Prefetchable {

  /** The number of further waits after the end of the run before the app is given up. */
  private static final int MAX_REFUSALS = 1000;

  /** The limit of awaits that return at once, in one action. */
  static final int MAX_AWAITS = 100_000;

  private final Kernel kernel;
  private final SimStrand strand;
  private @Nullable Runnable body;
  private @Nullable Carrier carrier;
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

  void start() {
    if (!strand.isClosed()) {
      wakeSlot = kernel.add(kernel.nowNs(), strand, this);
    }
  }

  @Override
  public int prefetch() {
    Carrier waiting = carrier;
    return waiting == null ? 0 : waiting.touch();
  }

  /** Whether the app itself runs on the strand now. */
  boolean isRunning() {
    return isRunning;
  }

  /** The app's thread while the app runs, or null; for a watch on another thread. */
  @Nullable Thread runningThread() {
    Carrier mine = carrier;
    return isRunning && mine != null ? mine.thread() : null;
  }

  /** Where the app waits or runs; empty if it has not started or has ended. */
  StackTraceElement[] stack() {
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
    if (!strand.isClosed() && newCondition.getAsBoolean()) {
      awaits++;
      if (awaits > MAX_AWAITS) {
        throw Stalled.awaits(MAX_AWAITS);
      }
      return true;
    }
    suspend(newCondition, deadlineNs, deadlineNs != Long.MAX_VALUE);
    return conditionHeld;
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
    if (waiting == null) {
      return null;
    }
    try {
      if (isLost) {
        runOn(waiting);
      }
      if (carrier != null) {
        resume();
      }
      return carrier == null
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
      refuse(mine);
    }
    awaits = 0;
    suspendedNs = kernel.nowNs();
    strand.awaited = newCondition;
    if (isTimed) {
      wakeSlot = kernel.add(Math.max(untilNs, kernel.nowNs()), strand, this);
    }
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

  private void refuse(Carrier mine) {
    refusals++;
    if (refusals > MAX_REFUSALS) {
      mine.suspend();
    }
    throw new StrandClosed();
  }

  private void resume() {
    Carrier mine = carrier;
    if (mine == null) {
      mine = kernel.carry(strand, this::runBody);
      carrier = mine;
    }
    runOn(mine);
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
    kernel.appIsOver(strand);
  }
}
