package org.starl.sim.kernel;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** A platform thread that runs only while it holds the baton; the kernel waits for the baton. */
final class PlatformCarrier implements Carrier {

  // The stack size; as large as the stack of the kernel's thread, on which virtual threads run.
  private static final long STACK_BYTES = 1 << 20;

  private final Thread thread;
  private final Duration foreignWaitLimit;
  private boolean isStarted;
  private @Nullable Thread kernelThread;
  private volatile boolean appHasBaton;

  PlatformCarrier(String name, Runnable app, Duration foreignWaitLimit) {
    this.foreignWaitLimit = foreignWaitLimit;
    Runnable body =
        () -> {
          try {
            app.run();
          } finally {
            passBatonToKernel();
          }
        };
    this.thread = new Thread(null, body, name, STACK_BYTES, false);
    this.thread.setDaemon(true);
  }

  @Override
  public Thread thread() {
    return thread;
  }

  @Override
  public void resume() {
    kernelThread = Thread.currentThread();
    appHasBaton = true;
    if (isStarted) {
      LockSupport.unpark(thread);
    } else {
      isStarted = true;
      thread.start();
    }
    awaitBaton();
  }

  @Override
  public void recover() {
    // The app still holds the baton. Passing it again could undo the app's own passing.
    kernelThread = Thread.currentThread();
    thread.interrupt();
    awaitBaton();
  }

  private void awaitBaton() {
    BoundedWait wait = new BoundedWait(foreignWaitLimit);
    try {
      while (appHasBaton) {
        if (!wait.park(this)) {
          if (isWaiting()) {
            throw NonKernelWait.tooLong(thread, foreignWaitLimit);
          }
          wait.restart();
        }
      }
    } finally {
      wait.close();
    }
  }

  /** Does nothing: the app runs on another processor, which has its own cache. */
  @Override
  public int touch() {
    return 0;
  }

  @Override
  public void suspend() {
    passBatonToKernel();
    boolean wasInterrupted = false;
    while (!appHasBaton) {
      LockSupport.park(this);
      // An interrupted thread does not park: it would spin until it gets the baton.
      wasInterrupted |= Thread.interrupted();
    }
    if (wasInterrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void passBatonToKernel() {
    appHasBaton = false;
    LockSupport.unpark(kernelThread);
  }

  // An app may compute without limit; a thread in a native call waits for input.
  private boolean isWaiting() {
    StackTraceElement[] stack = thread.getStackTrace();
    return thread.getState() != Thread.State.RUNNABLE
        || (stack.length > 0 && stack[0].isNativeMethod());
  }
}
