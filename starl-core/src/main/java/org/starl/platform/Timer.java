package org.starl.platform;

/**
 * A reusable timer: setting it allocates nothing. Strand only.
 *
 * <p>A timer that was cancelled or set again never runs its action for the older setting, even if
 * that had expired and was waiting for the strand.
 */
public interface Timer {

  /** No time: a timer set to it is cancelled. */
  long NEVER = Long.MAX_VALUE;

  /**
   * Expires once at {@code atNs}; if that is past, as soon as possible, but not inside this call. No
   * effect if it is set to that time already; {@link #NEVER} cancels.
   */
  void set(long atNs);

  /** Cancels the pending expiry, if any. */
  void cancel();

  /** Whether an expiry is pending. */
  boolean isSet();
}
