package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.ledger.Seen.A;
import static org.starl.primitives.ledger.Seen.ADD;
import static org.starl.primitives.ledger.Seen.B;
import static org.starl.primitives.ledger.Seen.BEGIN_A;
import static org.starl.primitives.ledger.Seen.CLAIM_A;
import static org.starl.primitives.ledger.Seen.FINISH_A;
import static org.starl.primitives.ledger.Seen.FREE;
import static org.starl.primitives.ledger.Seen.PA2;
import static org.starl.primitives.ledger.Seen.REOPEN;
import static org.starl.primitives.ledger.Seen.START_A;
import static org.starl.primitives.ledger.Seen.applies;
import static org.starl.primitives.ledger.Seen.isTold;

import org.junit.jupiter.api.Test;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.ledger.LedgerAutomaton.States;

/** Which events are which actions, line by line of the table; and what is no run of {@code Ledger_decls}. */
class LedgerConformanceTest {

  private final ShownRun<States, LedgerAction> run = new ShownRun<>(LedgerConformance::new);

  @Test
  void eventsMapToTheActionsInTheTable() {
    run.has(applies(0, A, 1, 1, START_A, ADD));
    run.has(applies(0, B, 1, 1, START_A, ADD));
    run.has(applies(0, A, 2, 1, CLAIM_A, BEGIN_A));
    run.has(isTold(0, A, BEGIN_A, LedgerOutcome.DONE));
    run.has(isTold(0, A, BEGIN_A, LedgerOutcome.UNKNOWN));
    run.has(applies(0, A, 3, 1, REOPEN, new LedgerEntry.Start(PA2)));
    run.has(applies(0, A, 4, 1, new LedgerEntry.Claim(Seen.T, 2, PA2)));
    run.has(applies(0, A, 5, 1, new LedgerEntry.Free(Seen.T, 2)));
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "restart(a)",
            "told(a) = ()",
            "insert(orders/1)",
            "take(a, orders/1, 1)",
            "commit(a, orders/1, 1)",
            "tell(a, orders/1, 1)",
            "told(a) = 1",
            "reopen(orders/1, 1)",
            "restart(a)",
            "told(a) = ()",
            "take(a, orders/1, 2)",
            "free(orders/1, 2)");
  }

  @Test
  void aBeginAfterTheClaimHasEndedDeviates() {
    run.has(applies(0, A, 1, 1, START_A, ADD, CLAIM_A, FREE, BEGIN_A));
    assertThat(run.details()).hasSize(1);
    assertThat(new LedgerConformance().lemmas()).containsExactly("Ledger_decls");
    assertThat(run.details().get(0)).contains("commit(a, orders/1, 1) is not enabled");
  }

  @Test
  void aFinishWithoutABeginDeviates() {
    run.has(applies(0, A, 1, 1, START_A, ADD, CLAIM_A, FINISH_A));
    assertThat(run.details()).hasSize(1);
  }

  @Test
  void aBeginThatIsToldAndNotInTheLogDeviates() {
    run.has(applies(0, A, 1, 1, START_A, ADD, CLAIM_A));
    run.has(isTold(0, A, BEGIN_A, LedgerOutcome.DONE));
    assertThat(run.details()).hasSize(1);
  }
}
