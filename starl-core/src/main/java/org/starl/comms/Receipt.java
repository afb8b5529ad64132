package org.starl.comms;

/** What became of a reliable message. Strand only; see {@link Endpoint#sendReliably}. */
public interface Receipt {

  /**
   * The other end's handler has run, exactly once in the incarnation that acknowledged it. A
   * receiver that restarts forgets what it handled: the message may have been handled once by each
   * of its incarnations.
   */
  boolean isDelivered();

  /** Given up at the deadline; the other end may or may not have handled it, at most once. */
  boolean isFailed();

  /** Delivered or failed; for {@code await(receipt::isSettled)}. */
  default boolean isSettled() {
    return isDelivered() || isFailed();
  }

  /** Calls {@code action} on the strand when it settles; at once if it has. */
  void whenSettled(Runnable action);
}
