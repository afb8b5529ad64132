package org.starl.sim.kernel;

import java.lang.reflect.Constructor;
import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * A virtual thread that is scheduled by this object: it runs only on the kernel's thread, inside
 * {@link #resume}.
 *
 * <p>An app that blocks outside the kernel is made runnable by another thread. That thread only
 * hands over the continuation; the kernel, which waits in {@code resume}, runs it.
 */
final class VirtualCarrier implements Carrier, Executor {

  private static final @Nullable Constructor<?> BUILDER = findBuilder();

  private final Thread thread;
  private final Duration foreignWaitLimit;
  private final PinWatch pinWatch;
  private boolean isStarted;
  private boolean isSuspended;
  private long resumes;
  private @Nullable Thread kernelThread;
  private @Nullable Runnable continuation;
  private boolean isReady;
  private volatile @Nullable Runnable readyFromOutside;
  private volatile boolean pinnedWaitFails;

  VirtualCarrier(String name, Runnable app, Duration foreignWaitLimit, PinWatch pinWatch) {
    this.foreignWaitLimit = foreignWaitLimit;
    this.pinWatch = pinWatch;
    this.thread = newBuilder(this).name(name).inheritInheritableThreadLocals(false).unstarted(app);
  }

  static boolean isSupported() {
    return BUILDER != null;
  }

  @Override
  public Thread thread() {
    return thread;
  }

  @Override
  public void resume() {
    rememberKernelThread();
    if (isStarted) {
      isSuspended = false;
      LockSupport.unpark(thread);
    } else {
      isStarted = true;
      thread.start();
    }
    runUntilSuspended();
  }

  @Override
  public int touch() {
    // The thread's state is stored far behind its header.
    return Cache.prefetch(continuation) + thread.getState().ordinal();
  }

  @Override
  public void recover() {
    rememberKernelThread();
    thread.interrupt();
    runUntilSuspended();
  }

  // Two threads may run a kernel one after the other. Storing an unchanged value would cost a write
  // barrier of the garbage collector at each resume.
  private void rememberKernelThread() {
    Thread current = Thread.currentThread();
    if (kernelThread != current) {
      kernelThread = current;
    }
  }

  private void runUntilSuspended() {
    resumes++;
    pinWatch.setResumed(this);
    try {
      do {
        takeReady().run();
      } while (!isSuspended && thread.isAlive());
    } finally {
      pinWatch.setResumed(null);
    }
  }

  @Override
  public void suspend() {
    isSuspended = true;
    boolean wasInterrupted = false;
    LockSupport.park();
    while (isSuspended) {
      // A left-over permit or an interrupt ends a park but not the suspension, and an interrupted
      // thread would not park again.
      wasInterrupted |= Thread.interrupted();
      if (pinnedWaitFails) {
        isSuspended = false;
        throw new NonKernelWait(
            "sleep and await do not work inside a static initialiser or a native method",
            thread.getStackTrace());
      }
      LockSupport.park();
    }
    if (wasInterrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * The number of times the app was resumed. This and the two methods below are for the watch's
   * thread.
   */
  long resumes() {
    return resumes;
  }

  /** Whether the app has suspended itself but still occupies the kernel's thread. */
  boolean seemsPinned() {
    return isSuspended && thread.getState() == Thread.State.WAITING;
  }

  /** Makes the app's suspension throw. */
  void failPinnedWait() {
    pinnedWaitFails = true;
    LockSupport.unpark(thread);
  }

  /** Called by the thread that makes the virtual thread runnable: usually the kernel, in resume. */
  @Override
  public void execute(Runnable runnable) {
    if (Thread.currentThread() == kernelThread) {
      // The one continuation of the virtual thread; usually it is stored already.
      if (continuation != runnable) {
        continuation = runnable;
      }
      isReady = true;
    } else {
      readyFromOutside = runnable;
      LockSupport.unpark(kernelThread);
    }
  }

  private Runnable takeReady() {
    Runnable ready = continuation;
    if (!isReady || ready == null) {
      return awaitReadyFromOutside();
    }
    isReady = false;
    return ready;
  }

  private Runnable awaitReadyFromOutside() {
    BoundedWait wait = new BoundedWait(foreignWaitLimit);
    try {
      Runnable ready = readyFromOutside;
      while (ready == null) {
        if (!wait.park(this)) {
          throw NonKernelWait.tooLong(thread, foreignWaitLimit);
        }
        ready = readyFromOutside;
      }
      readyFromOutside = null;
      return ready;
    } finally {
      wait.close();
    }
  }

  private static Thread.Builder.OfVirtual newBuilder(Executor scheduler) {
    if (BUILDER == null) {
      throw new IllegalStateException(String.valueOf(CarrierKind.fallbackReason()));
    }
    try {
      return (Thread.Builder.OfVirtual) BUILDER.newInstance(scheduler);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("no virtual thread with a scheduler of its own", e);
    }
  }

  // The JDK has no public API for a virtual thread with a custom scheduler.
  private static @Nullable Constructor<?> findBuilder() {
    try {
      Constructor<?> constructor =
          Class.forName("java.lang.ThreadBuilders$VirtualThreadBuilder")
              .getDeclaredConstructor(Executor.class);
      return constructor.trySetAccessible() ? constructor : null;
    } catch (ReflectiveOperationException e) {
      return null;
    }
  }
}
