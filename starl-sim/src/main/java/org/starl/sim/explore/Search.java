package org.starl.sim.explore;

import java.util.List;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.fault.Fault;

/** Gives the schedules of an exploration in their order. */
interface Search {

  /** A schedule to run; see {@link Explored}. */
  record Node(List<Long> place, List<Fault> schedule, int decided, int losses, int crashes) {}

  /**
   * The next schedules, at most so many; none at the end. Before the next call each of them is given
   * to {@link #took}, in this order.
   */
  List<Node> next(int most);

  /** The number of copies that make the order of a run. */
  int mostCopies(Node node);

  /** Whether a schedule that ran before must run again, because others follow from its copies. */
  boolean needsAgain(Node node);

  /** What is kept of a run that has ended; to be called in the order of {@link #next}. */
  Explored explored(Node node, RunOutcome outcome, Order order);

  /** Goes on after a schedule. */
  void took(Explored explored);

  /** Whether no schedule is left. */
  boolean isAll();
}
