package org.starl.platform;

import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Executes all code of a robot (app, message handlers, timers), one piece at a time. Only the app
 * may wait, and it releases the strand only while it waits: the code between two waits is one
 * atomic action. Handlers and timers run to completion.
 */
public interface Strand {

  /** Starts the robot's app, the only piece of the strand that may wait. Call one of the two once. */
  void start(Runnable app);

  /** Starts the robot's app, which has no thread: it waits by {@link #suspendUntil}. */
  void start(SuspendedApp app);

  /**
   * Runs {@code action} on this strand later, as one atomic piece, after all actions posted before
   * it. The only method that may be called from outside the strand.
   */
  void post(Runnable action);

  /** Whether the calling code runs on this strand. */
  boolean isCurrent();

  /**
   * Releases the strand until {@code atNs}. If that is not in the future, first runs everything
   * else that is due now, then returns. Only the app may call it.
   *
   * @throws StrandClosed if the run ends meanwhile
   * @throws IllegalStateException if the caller is not the app of this strand
   */
  void sleepUntil(long atNs);

  /**
   * Releases the strand until {@code condition} holds or it is {@code deadlineNs} ({@code
   * Long.MAX_VALUE}: no deadline). The condition is evaluated at once, and then on the strand after
   * each piece; it must be cheap and without side effects. Only the app may call it.
   *
   * @return whether the condition held
   * @throws StrandClosed if the run ends meanwhile
   */
  boolean awaitUntil(BooleanSupplier condition, long deadlineNs);

  /**
   * Begins a wait of a {@link SuspendedApp}: as {@link #awaitUntil}, or as {@link #sleepUntil} without
   * a condition. Unless the condition holds already, the app returns from {@link SuspendedApp#resume},
   * and is resumed at the end of the wait, in the same order as another app.
   *
   * @param continuation where the app goes on: {@link SuspendedApp#resume} gets it back
   * @return whether the condition holds already: then there is no wait
   * @throws StrandClosed if the run has ended
   * @throws IllegalStateException if the caller is not the app of this strand
   */
  boolean suspendUntil(@Nullable BooleanSupplier condition, long deadlineNs, Object continuation);
}
