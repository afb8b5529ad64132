package org.starl.sim.net;

/** A recipient's strand, as the network needs it: {@code simStrand::schedule}. */
@FunctionalInterface
public interface Inbox {

  /** Runs {@code piece} on the strand at {@code atNs}, never inside this call. */
  void schedule(long atNs, Runnable piece);
}
