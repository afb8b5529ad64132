package org.starl.primitives.ledger;

/** A call of a ledger: {@code await(call::isDone)}. Strand only. */
public final class LedgerCall {

  private LedgerOutcome outcome = LedgerOutcome.PENDING;

  LedgerCall() {}

  /** Whether the outcome is known, or was given up. */
  public boolean isDone() {
    return outcome != LedgerOutcome.PENDING;
  }

  public LedgerOutcome outcome() {
    return outcome;
  }

  void settle(LedgerOutcome told) {
    outcome = told;
  }
}
