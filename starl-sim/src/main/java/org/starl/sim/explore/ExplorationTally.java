package org.starl.sim.explore;

import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** Adds up an exploration, schedule by schedule in their order. */
public final class ExplorationTally {

  private final long mostSchedules;
  private final Set<Long> orders = new TreeSet<>();
  private long schedules;
  private long steps;
  private Explorer.@Nullable Found found;

  public ExplorationTally(Exploration exploration) {
    mostSchedules = exploration.mostSchedules();
  }

  /** Adds the next schedule, and answers whether it is the last one to count. */
  public boolean add(Explored explored) {
    steps += explored.steps();
    if (explored.order() != null) {
      orders.add(explored.order());
    }
    if (!explored.outcome().isGood()) {
      found = new Explorer.Found(schedules, explored.schedule(), explored.outcome());
    }
    schedules++;
    return found != null || schedules == mostSchedules;
  }

  /**
   * The sums.
   *
   * @param isAll whether no schedule within the bounds is left
   */
  public Explorer.Result result(boolean isAll) {
    return new Explorer.Result(schedules, orders.size(), steps, found == null && isAll, found);
  }
}
