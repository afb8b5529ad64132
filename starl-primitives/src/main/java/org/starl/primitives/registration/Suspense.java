package org.starl.primitives.registration;

import org.starl.random.Rng;

/**
 * The time between hearing of a proposal for a higher number and learning that number. Meanwhile the
 * list that is known is hidden, for the paper's interface has null between two lists; no longer than
 * a bound, and then it is shown until the next one is learned, so that a stream of proposals cannot
 * hide it for ever. Nothing safe rests on hiding.
 *
 * <p>A number that is not learned within the bound is asked for; and after about as long again it is
 * worked for, since whoever proposed it may be gone, and may have had it decided.
 */
final class Suspense {

  /** What a timer finds to be done. */
  enum Due {
    NOTHING,
    ASK,
    COMPLETE
  }

  private final long boundNs;
  private final Rng rng;
  private long learned;
  private long rumoured;
  private boolean patienceIsOver;
  private Due next = Due.NOTHING;
  private long wakeAtNs = Long.MAX_VALUE;

  Suspense(long boundNs, Rng rng) {
    this.boundNs = boundNs;
    this.rng = rng;
  }

  /** Whether the list that is known is shown. */
  boolean isListShown() {
    return rumoured <= learned || patienceIsOver;
  }

  void rumour(long number, long nowNs) {
    boolean wasShown = isListShown();
    rumoured = Math.max(rumoured, number);
    hideIfNew(wasShown, nowNs);
  }

  void learned(long number, long nowNs) {
    boolean wasShown = isListShown();
    learned = Math.max(learned, number);
    patienceIsOver = false;
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
      patienceIsOver = true;
      // At random, so that not all who wait begin at once.
      await(Due.COMPLETE, nowNs + boundNs + rng.nextLong(0, boundNs));
    } else {
      await(Due.NOTHING, Long.MAX_VALUE);
    }
    return due;
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
