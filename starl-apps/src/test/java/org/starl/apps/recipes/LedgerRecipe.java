package org.starl.apps.recipes;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.ledger.Allocation;
import org.starl.primitives.ledger.LedgerCall;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.ledger.LedgerPrim;
import org.starl.primitives.ledger.TaskId;
import org.starl.primitives.ledger.TaskLedger;
import org.starl.shape.Shapes;

final class LedgerRecipe extends LogicThread {

  private static final int ORDERS = 6;

  private final LedgerPrim<Double> ledger; // a task is a place on a line, in mm
  private final List<Object> done = new ArrayList<>();

  LedgerRecipe(GlobalVarHolder gvh) {
    super(gvh);
    ledger = new TaskLedger<>(gvh, "deliveries", Shapes.REAL);
  }

  @Override
  public List<Object> callStarL() {
    await(() -> ledger.ready().get() && gvh.gps.hasFix());
    ledger.held().get().forEach(this::deliver); // what an earlier program has begun
    for (int i = 1; i <= ORDERS; i++) {
      told(ledger.add(new TaskId("orders", i), 500.0 * i)); // all robots add all orders
    }
    while (!ledger.tasks().isEmpty()) {
      double xMm = gvh.gps.pose().xMm();
      SortedSet<TaskId> mine = ledger.held().get(); // also by a call that was told UNKNOWN
      Optional<TaskId> next =
          Allocation.nearest(ledger.tasks().values(), placeMm -> Math.abs(placeMm - xMm));
      if (!mine.isEmpty()) {
        next = Optional.of(mine.first());
      }
      if (next.isPresent()
          && (!mine.isEmpty() || told(ledger.claim(next.get())) == LedgerOutcome.DONE)
          && told(ledger.begin(next.get())) == LedgerOutcome.DONE) {
        deliver(next.get());
      } else {
        sleep(500);
      }
    }
    return done;
  }

  private void deliver(TaskId task) {
    sleep(1_000); // it alone has the goods
    while (ledger.tasks().containsKey(task)) {
      told(ledger.finish(task)); // again, if it is UNKNOWN
    }
    done.add(task);
  }

  private LedgerOutcome told(LedgerCall call) {
    await(call::isDone);
    return call.outcome();
  }
}
