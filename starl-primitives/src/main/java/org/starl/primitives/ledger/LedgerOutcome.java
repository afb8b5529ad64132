package org.starl.primitives.ledger;

/** What a robot was told of a call. */
public enum LedgerOutcome {
  /** It is not known yet. */
  PENDING,
  /** The change is in the log. To make the same change again is DONE, too. */
  DONE,
  /**
   * Another entry came first, and the change will never be made by this call: another robot was faster,
   * the claim has ended, or the task is finished.
   */
  LATE,
  /**
   * No majority has answered by the deadline. The change may still be made later: call again to know. A
   * robot that is told this of {@code begin} must not do the task yet.
   */
  UNKNOWN
}
