package org.starl.sim.kernel;

import java.time.Duration;

/**
 * An app blocks outside the kernel, for example in {@code Thread.sleep}, on a lock or for input.
 * The stack trace is the app's.
 */
final class NonKernelWait extends IllegalStateException {

  private static final long serialVersionUID = 1L;

  NonKernelWait(String message, StackTraceElement[] appStack) {
    super(message);
    setStackTrace(appStack);
  }

  static NonKernelWait tooLong(Thread app, Duration limit) {
    return new NonKernelWait(
        "the app has been waiting outside sleep and await for "
            + limit.toMillis()
            + " ms of real time: use gvh.sleep / sleep(ms), or await",
        app.getStackTrace());
  }
}
