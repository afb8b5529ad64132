package org.starl.comms;

/** The state of a reliable message. Strand only; see {@link Endpoint#sendReliably}. */
public interface Receipt {

  /**
   * Whether the receiver has acknowledged the message: its handler has run exactly once in the
   * incarnation that acknowledged. A receiver that restarts forgets what it handled, so each of its
   * incarnations may have handled the message once.
   */
  boolean isDelivered();

  /**
   * Whether the sender has given up. The receiver may or may not have handled the message, at most
   * once per incarnation.
   */
  boolean isFailed();

  /** Whether the message is delivered or failed; for {@code await(receipt::isSettled)}. */
  default boolean isSettled() {
    return isDelivered() || isFailed();
  }

  /**
   * Calls {@code action} on the strand when the message is delivered or failed; at once if it is
   * already.
   */
  void whenSettled(Runnable action);
}
