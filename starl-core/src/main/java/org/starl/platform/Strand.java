package org.starl.platform;

import java.util.function.BooleanSupplier;

/**
 * Where everything that a robot does runs, at most one piece at a time: its app, its message
 * handlers, its timers. The app alone may wait, and gives up the strand only while it waits, so
 * what lies between two waits is one atomic action. Handlers and timers run to completion.
 */
public interface Strand {

  /** Starts the robot's app as the strand's one piece that may wait. Called once. */
  void start(Runnable app);

  /**
   * Runs {@code action} on this strand as one atomic piece, later, after what was posted before it.
   * The only call that is allowed from outside the strand.
   */
  void post(Runnable action);

  /** Whether the caller runs on this strand now. */
  boolean isCurrent();

  /**
   * Gives up the strand until {@code atNs}; returns at once, yet after everything else that is due
   * now, if that is not in the future. Only the app may call it.
   *
   * @throws StrandClosed if the run ends meanwhile
   * @throws IllegalStateException if the caller is not the app of this strand
   */
  void sleepUntil(long atNs);

  /**
   * Gives up the strand until {@code condition} holds or it is {@code deadlineNs} ({@code
   * Long.MAX_VALUE}: no deadline). The condition is evaluated at once, and then on the strand after
   * each piece that ran on it; it must be cheap and without side effects. Only the app may call it.
   *
   * @return whether the condition held
   * @throws StrandClosed if the run ends meanwhile
   */
  boolean awaitUntil(BooleanSupplier condition, long deadlineNs);
}
