package org.starl.sim.explore;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.fault.Fault;

/**
 * A schedule that ran.
 *
 * @param place in the exploration. Of a drawn schedule: its number, from 0, which is the run without
 *     changes. Of an exhaustive search: which of the possible changes was made at each step, so the
 *     run without changes has an empty place
 * @param order a hash of the order of its events; null for the run without changes of a strategy that
 *     draws, from whose copies the others are drawn
 * @param steps events of the kernel
 * @param next the changes after which the exhaustive search goes on; empty if it does not
 */
public record Explored(
    List<Long> place,
    List<Fault> schedule,
    RunOutcome outcome,
    @Nullable Long order,
    long steps,
    List<Change> next) {

  /**
   * A schedule with one fault more.
   *
   * @param decided the number of copies that are decided: later ones may still be changed
   * @param losses of the whole schedule, as {@code crashes}
   */
  public record Change(Fault fault, int decided, int losses, int crashes) {}

  public Explored {
    place = List.copyOf(place);
    schedule = List.copyOf(schedule);
    next = List.copyOf(next);
  }
}
