package org.starl.primitives.agreement;

import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Replays;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every {@link SetAgreement} is a run of the theory {@code SetAgreement_decls}: the
 * lemma is its name. What happens is taken for an action of the theory so, {@code i} being its robot:
 *
 * <pre>
 * event                              action
 * propose v                          propose(i, v)
 * decided v, as the first to know    choose(v): nobody tells when it is chosen
 * decided v                          decide(i), decided(i) is v
 * decided null                       restart(i), if its program before knew a decision; else a stutter
 * all other events                   stutter
 * </pre>
 *
 * What is kept is what was proposed, and who knows the decision.
 */
public final class AgreementConformance extends Conformance {

  private final Replays<States, AgreementAction> replays;

  public AgreementConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  public AgreementConformance(Steps<States, AgreementAction> steps) {
    super(AgreementAutomaton.SET_AGREEMENT_DECLS, "every agreement");
    replays = new Replays<>(new AgreementAutomaton(), steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Action action
          when SetAgreement.isAgreement(action.source())
              && action.name().equals(SetAgreement.PROPOSE) ->
          replays
              .of(action.source())
              .step(
                  action,
                  new AgreementAction.propose(action.robot(), action.args().get(0)),
                  report);
      case Variable variable
          when SetAgreement.isAgreement(variable.source())
              && variable.name().equals(SetAgreement.DECIDED) ->
          shown(variable, replays.of(variable.source()), report);
      default -> {
        // A stutter.
      }
    }
  }

  private static void shown(
      Variable variable, Replay<States, AgreementAction> replay, Report report) {
    RobotId i = variable.robot();
    String value = variable.value();
    if (value.equals(Decision.NONE_YET.toString())) {
      if (replay.state().decided().at(i).isUp()) {
        replay.step(variable, new AgreementAction.restart(i), report);
      }
      return;
    }
    if (!replay.state().value().isUp()) {
      replay.step(variable, new AgreementAction.choose(value), report);
    }
    replay.step(variable, new AgreementAction.decide(i), report);
    replay.<Lift<String>>result(
        variable, "decided", i, new Lift.up<>(value), replay.state().decided().at(i), report);
  }
}
