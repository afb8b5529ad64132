package org.starl.primitives.registration;

/**
 * When a list that is known is hidden all the same: from the time a proposal for a higher number is
 * heard of, until that number is learned, and no longer than a bound. After the bound the list is
 * shown until the next one is learned, so that a stream of proposals cannot hide it for ever.
 *
 * <p>This serves the paper's interface only, which has null between two lists; nothing safe rests
 * on it.
 */
final class RListRule {

  private final long boundNs;
  private long learned;
  private long rumoured;
  private long hiddenUntilNs = Long.MAX_VALUE;
  private boolean patienceIsOver;

  RListRule(long boundNs) {
    this.boundNs = boundNs;
  }

  boolean isShown() {
    return rumoured <= learned || patienceIsOver;
  }

  void rumour(long number, long nowNs) {
    boolean wasShown = isShown();
    rumoured = Math.max(rumoured, number);
    hideIfNew(wasShown, nowNs);
  }

  void learned(long number, long nowNs) {
    boolean wasShown = isShown();
    learned = Math.max(learned, number);
    patienceIsOver = false;
    hideIfNew(wasShown, nowNs);
    if (isShown()) {
      hiddenUntilNs = Long.MAX_VALUE;
    }
  }

  long wakeAtNs() {
    return hiddenUntilNs;
  }

  /** Returns whether the bound has just passed in vain. */
  boolean timer(long nowNs) {
    if (nowNs < hiddenUntilNs) {
      return false;
    }
    hiddenUntilNs = Long.MAX_VALUE;
    patienceIsOver = true;
    return true;
  }

  private void hideIfNew(boolean wasShown, long nowNs) {
    if (wasShown && !isShown()) {
      hiddenUntilNs = nowNs + boundNs;
    }
  }
}
