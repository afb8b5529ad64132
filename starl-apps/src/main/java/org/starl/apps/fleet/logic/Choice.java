package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.starl.primitives.ledger.Allocation;
import org.starl.primitives.ledger.LedgerTask;
import org.starl.primitives.ledger.TaskId;
import org.starl.time.Time;

/**
 * Which delivery a free robot claims: the nearest open one that has no station in common with one under way,
 * as the robot would stand at one station and wait for the other. If those under way do not end, the
 * nearest of all. Never one that a dead robot makes impossible.
 */
final class Choice {

  // Deliveries under way end within this time, or never.
  static final long UNDER_WAY_NS = 300 * Time.NS_PER_S;

  private Set<Integer> busy = Set.of(); // the stations of the deliveries under way
  private long busySinceNs; // since when these are the same

  /**
   * @param isShut whether a dead robot keeps a station of it, or all ways, closed
   * @param mm to a delivery
   */
  Optional<TaskId> nearest(
      Collection<LedgerTask<Delivery>> all,
      Predicate<Delivery> isShut,
      long nowNs,
      ToDoubleFunction<Delivery> mm) {
    Set<Integer> stations = new TreeSet<>();
    List<LedgerTask<Delivery>> tasks = new ArrayList<>(all);
    tasks.stream()
        .filter(task -> !task.isOpen())
        .forEach(task -> stations.addAll(task.what().stops()));
    if (!stations.equals(busy)) {
      busy = stations;
      busySinceNs = nowNs;
    }
    if (nowNs - busySinceNs < UNDER_WAY_NS) {
      tasks.removeIf(task -> !Collections.disjoint(busy, task.what().stops()));
    }
    tasks.removeIf(task -> task.isOpen() && isShut.test(task.what()));
    return Allocation.nearest(tasks, mm);
  }
}
