package org.starl.primitives.barrier;

import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every barrier is a run of the theory {@code Barrier_decls}. The fact {@code arrive} is
 * an action of the theory, if its id is one of the event's robot. The map of other events to actions,
 * where {@code i} is the id that the event's robot announced last:
 *
 * <pre>
 * event                            action
 * Barrier i members                none: the robot announces its id i. The members of the instance's
 *                                  first such event are the parameter first; all others must be equal
 * outcome g:passed, g:failed[M],
 *   for the first time             decide(g, passed), decide(g, failed(M))
 * outcome g:passed, g:failed[M]    tell(i, g); told(i) is this
 * outcome g:excluded               tell(i, g); told(i) is failed(M), and i is in M
 * outcome null, 0:excluded,
 *   g:unknown                      none: the robot was never a member, or learned nothing
 * all other events                 none, and so are all before the instance's first Barrier
 * </pre>
 *
 * <p>The decision of a generation is not in the trace: it is mapped to the first event that shows the
 * outcome. Generations are told in order, since a robot arrives in the next one only after it was told
 * the one before. {@code excluded} does not say which other members are excluded. So where no robot
 * has shown the outcome yet, the {@code tell} waits for it, or for the end of the run; at the end, the
 * robots that were told so are taken to be all excluded ones. If any run of the theory fits, this one
 * does: nothing else depends on that outcome.
 *
 * <p>Memory grows with the ids and outcomes, and with the arrivals in undecided generations.
 */
public final class BarrierConformance extends Conformance<BarrierRun> {

  public BarrierConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  BarrierConformance(AutomatonListener<States, BarrierAction> steps) {
    super(
        BarrierAutomaton.BARRIER_DECLS,
        "every barrier",
        source -> new BarrierRun(source, steps),
        BarrierFact.PRIMITIVE);
  }

  @Override
  protected void acted(Action action, Report report) {
    BarrierRun run = instance(action.source());
    switch (action.fact()) {
      case BarrierFact.Created created -> run.created(action, created, report);
      case BarrierAction step when action.process() != null -> run.stepped(action, step, report);
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    BarrierOutcome outcome = variable.of(BarrierFact.OUTCOME);
    if (outcome != null) {
      instance(variable.source()).shown(variable, outcome, report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    instances().values().forEach(run -> run.finish(report));
  }
}
