package org.starl.primitives.agreement;

import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every {@link SetAgreement} is a run of the theory {@code SetAgreement_decls}. The fact
 * {@code propose} is an action of the theory. The map of other events to actions, where {@code i} is
 * the event's robot:
 *
 * <pre>
 * event                          action
 * decided v, for the first time  choose(v): the decision itself is not in the trace
 * decided v                      decide(i); decided(i) is v
 * decided null                   restart(i), if the robot's program before knew a decision;
 *                                decided(i) is none
 * all other events               none
 * </pre>
 *
 * Memory grows with the proposed values, and with the robots that know the decision.
 */
public final class AgreementConformance extends Conformance<Replay<States, AgreementAction>> {

  public AgreementConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public AgreementConformance(AutomatonListener<States, AgreementAction> steps) {
    super(
        AgreementAutomaton.SET_AGREEMENT_DECLS,
        "every agreement",
        source -> new Replay<>(new AgreementAutomaton(), source, steps),
        AgreementFact.PRIMITIVE);
  }

  @Override
  protected void acted(Action action, Report report) {
    if (action.fact() instanceof AgreementAction.propose proposal) {
      instance(action.source()).step(action, proposal, report);
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    Decision<?> shown = variable.of(AgreementFact.DECIDED);
    if (shown == null) {
      return;
    }
    Replay<States, AgreementAction> replay = instance(variable.source());
    RobotId i = variable.robot();
    if (!shown.isDecided()) {
      if (replay.state().decided().at(i).isUp()) {
        replay.step(variable, new AgreementAction.restart(i), report);
        replay.<Lift<String>>result(
            variable, "decided", i, new Lift.bottom<>(), replay.state().decided().at(i), report);
      }
      return;
    }
    String value = shown.toString(); // as in the proposal
    if (!replay.state().value().isUp()) {
      replay.step(variable, new AgreementAction.choose(value), report);
    }
    replay.step(variable, new AgreementAction.decide(i), report);
    replay.<Lift<String>>result(
        variable, "decided", i, new Lift.up<>(value), replay.state().decided().at(i), report);
  }
}
