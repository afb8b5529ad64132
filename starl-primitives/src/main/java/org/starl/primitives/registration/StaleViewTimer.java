package org.starl.primitives.registration;

import org.starl.random.Rng;

/**
 * Watches the time between a rumour of a higher view number and learning that view. Meanwhile the known
 * list is hidden, since the paper's interface shows null between two lists. After a bound it is shown
 * again until the next view is learned, so that a series of proposals cannot hide it for ever. Safety
 * does not depend on hiding.
 *
 * <p>When the bound is over, the view is asked for. After about as long again this robot proposes for
 * that number itself: the proposer may have gone, perhaps after the decision.
 */
final class StaleViewTimer {

  /** The action that is due. */
  enum Due {
    NOTHING,
    ASK,
    COMPLETE
  }

  private final long boundNs;
  private final Rng rng;
  private long learned;
  private long rumoured;
  private boolean expired;
  private Due next = Due.NOTHING;
  private long wakeAtNs = Long.MAX_VALUE;

  StaleViewTimer(long boundNs, Rng rng) {
    this.boundNs = boundNs;
    this.rng = rng;
  }

  /** Whether the known list is shown. */
  boolean isListShown() {
    return rumoured <= learned || expired;
  }

  void rumour(long number, long nowNs) {
    boolean wasShown = isListShown();
    rumoured = Math.max(rumoured, number);
    hideIfNew(wasShown, nowNs);
  }

  void learned(long number, long nowNs) {
    boolean wasShown = isListShown();
    learned = Math.max(learned, number);
    expired = false;
    hideIfNew(wasShown, nowNs);
    if (isListShown()) {
      await(Due.NOTHING, Long.MAX_VALUE);
    }
  }

  long wakeAtNs() {
    return wakeAtNs;
  }

  Due timer(long nowNs) {
    if (nowNs < wakeAtNs) {
      return Due.NOTHING;
    }
    Due due = next;
    if (due == Due.ASK) {
      expired = true;
      // At random, so that not all waiting robots begin at once.
      await(Due.COMPLETE, nowNs + boundNs + rng.nextLong(0, boundNs));
    } else {
      await(Due.NOTHING, Long.MAX_VALUE);
    }
    return due;
  }

  /** The state without times. */
  @Override
  public String toString() {
    return learned + " " + rumoured + expired + next;
  }

  private void hideIfNew(boolean wasShown, long nowNs) {
    if (wasShown && !isListShown()) {
      await(Due.ASK, nowNs + boundNs);
    }
  }

  private void await(Due due, long atNs) {
    next = due;
    wakeAtNs = atNs;
  }
}
