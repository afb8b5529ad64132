package org.starl.platform;

/**
 * One alarm, used again and again: setting it allocates nothing. Strand only.
 *
 * <p>A timer that was cancelled or set anew never runs its action for the older setting, even if
 * that setting had expired already and waited for the strand.
 */
public interface Timer {

  /** Expires once at {@code atNs} (at once, but not inside this call, if that is past). */
  void set(long atNs);

  /** Forgets the setting, if any. */
  void cancel();

  /** Whether an expiry is still to come. */
  boolean isSet();
}
