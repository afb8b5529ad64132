package org.starl.sim.kernel;

import java.lang.reflect.Constructor;
import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * A virtual thread whose scheduler is this object: it runs on the kernel's own thread, inside {@link
 * #resume}, and nowhere else.
 *
 * <p>An app that waits for something foreign is made runnable by a foreign thread. That thread only
 * hands the continuation over; the kernel, which waits in {@code resume}, runs it.
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
    // The thread's state lies far behind its first word.
    return Cache.prefetch(continuation) + thread.getState().ordinal();
  }

  @Override
  public void recover() {
    rememberKernelThread();
    thread.interrupt();
    runUntilSuspended();
  }

  // Two threads may run a kernel one after the other. Storing what is there already would cost the
  // collector's barrier at each resume.
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
      // A permit that a foreign thread has left over, or an interrupt, ends a park, but not the
      // suspension; and an interrupted thread would not park again.
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

  /** How often the app was resumed. As the two below, for the watch's thread. */
  long resumes() {
    return resumes;
  }

  /** Whether the app has suspended itself, although the kernel has not got its thread back. */
  boolean seemsPinned() {
    return isSuspended && thread.getState() == Thread.State.WAITING;
  }

  /** Makes the app's suspension throw. */
  void failPinnedWait() {
    pinnedWaitFails = true;
    LockSupport.unpark(thread);
  }

  /** Called by the thread that makes the virtual thread runnable: mostly the kernel, in resume. */
  @Override
  public void execute(Runnable runnable) {
    if (Thread.currentThread() == kernelThread) {
      // A virtual thread's one continuation: mostly it is there already.
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

  // The JDK has no public way to a virtual thread with another scheduler than its own.
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
