package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class AllocationTest {

  private static LedgerTask<Integer> task(int number, int cost) {
    return new LedgerTask<>(new TaskId("t", number), cost, 0, null, false);
  }

  @Test
  void theOpenTaskOfTheLeastCostIsChosen() {
    LedgerTask<Integer> held = task(1, 1).claimedBy(Seen.PA);
    List<LedgerTask<Integer>> tasks = List.of(task(5, 9), held, task(4, 3), task(2, 7));
    assertThat(Allocation.nearest(tasks, cost -> cost)).contains(new TaskId("t", 4));
    assertThat(Allocation.nearest(List.of(held), cost -> cost)).isEmpty();
    assertThat(Allocation.nearest(List.<LedgerTask<Integer>>of(), cost -> cost)).isEmpty();
  }

  @Test
  void ofEqualCostsTheFirstNameIsChosenInAnyOrder() {
    List<LedgerTask<Integer>> tasks = List.of(task(3, 5), task(2, 5), task(4, 5));
    assertThat(Allocation.nearest(tasks, cost -> cost)).contains(new TaskId("t", 2));
  }
}
