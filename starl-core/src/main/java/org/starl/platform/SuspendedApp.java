package org.starl.platform;

import org.jspecify.annotations.Nullable;

/**
 * An app without a thread of its own: where another app would block in a wait, it begins the wait by
 * {@link Strand#suspendUntil} and returns. Strand only.
 */
public interface SuspendedApp {

  /**
   * Runs the app from its start, or from its last wait, to the next wait or to its end. An exception
   * is the app's, as if it had a thread.
   *
   * @param continuation what it gave to its last wait; null at the start
   * @param held whether the condition of the last wait held; false at the start
   * @param closed null, or what the last wait throws because the run ends
   * @return whether the app has ended
   */
  boolean resume(@Nullable Object continuation, boolean held, @Nullable StrandClosed closed);

  /** Where it waits with {@code continuation}, the innermost line first; for messages. */
  StackTraceElement[] stack(Object continuation);

  /** The error of a blocking call in the app of {@code strand}. */
  static IllegalStateException blockingCall(Strand strand) {
    return new IllegalStateException(
        strand
            + ": a blocking call in an app that suspends: expected its suspending form, as in"
            + " sleep(100), await { crit.get() } or await(mutex.acquiring(sections, 60_000))");
  }
}
