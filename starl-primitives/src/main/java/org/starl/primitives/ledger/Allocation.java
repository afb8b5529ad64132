package org.starl.primitives.ledger;

import java.util.Collection;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** Which open task a free robot claims. Two robots may choose the same one: the log decides. */
public final class Allocation {

  private Allocation() {}

  /**
   * The open task of the least cost; of equal ones the first by its name. Empty if none is open.
   *
   * @param cost of a task to this robot, such as the distance to it in mm
   */
  public static <T> Optional<TaskId> nearest(
      Collection<LedgerTask<T>> tasks, ToDoubleFunction<? super T> cost) {
    TaskId best = null;
    double bestCost = Double.POSITIVE_INFINITY;
    for (LedgerTask<T> task : tasks) {
      double its = cost.applyAsDouble(task.what());
      boolean isEqual = its == bestCost && best != null && task.id().compareTo(best) < 0;
      if (task.isOpen() && (its < bestCost || isEqual)) {
        best = task.id();
        bestCost = its;
      }
    }
    return Optional.ofNullable(best);
  }
}
