package org.starl.primitives.registration;

import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every registration is a run of the theory {@code Registration_decls}. The map from
 * events to actions:
 *
 * <pre>
 * event                                  action
 * do_register i                          do_register(i), and learn(i, n) if its robot knows list n
 * unregister i                           unregister(i), if i is an id of the event's robot
 * give_up i                              give_up(i), if i is an id of the event's robot and has asked;
 *                                        gone(i) is true
 * confine i sections fencers             confine(i), if there are fencers, or i is an id of the
 *                                        event's robot
 * view n: L, for the first time          decide(L)
 * view n: L                              learn(i, n), where i is the id that the robot asked for
 *                                        last; rList(i) is L
 * rList n: robots                        none; rList(i) has these robots, and ts(i) is n
 * all other events                       none
 * </pre>
 *
 * <p>A list has the ids that are free in a view. A fenced id was confined: it is {@code gone}, and the
 * theory has no sections. The decision of a view is not in the trace. It is mapped to the first event
 * that shows the view, but after those of all lower numbers: a view that is seen too early waits for
 * them. A number that no robot has shown by the end of the run, or 256 numbers later, is taken to
 * repeat the list before it. If any run of the theory fits, this one does: {@code asked} and {@code
 * gone} only grow, and the repeated list admits no id.
 *
 * <p>A robot whose program has asked for no id, such as an acceptor, learns for no id. Memory holds the
 * ids of all attempts, and the latest 256 lists.
 */
public final class RegistrationConformance extends Conformance<RegistrationRun> {

  public RegistrationConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public RegistrationConformance(AutomatonListener<States, RegistrationAction> steps) {
    super(
        RegistrationAutomaton.REGISTRATION_DECLS,
        "every registration",
        source -> new RegistrationRun(new Replay<>(new RegistrationAutomaton(), source, steps)),
        RegistrationFact.PRIMITIVE);
  }

  @Override
  public void finish(long endNs, Report report) {
    instances().values().forEach(run -> run.finish(report));
  }

  @Override
  protected void acted(Action action, Report report) {
    RegistrationRun run = instance(action.source());
    switch (action.fact()) {
      case RegistrationAction.do_register asked -> run.asked(action, asked.i(), report);
      case RegistrationAction.unregister left -> run.unregistered(action, left.i(), report);
      case RegistrationAction.give_up gone -> run.gaveUp(action, gone.i(), report);
      case Confinement confinement when confinement.isSaidBy(action.robot()) ->
          run.step(action, new RegistrationAction.confine(confinement.who()), report);
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    RegistrationRun run = instance(variable.source());
    View view = variable.of(RegistrationFact.VIEW);
    if (view != null) {
      run.saw(variable, view, report);
    } else if (variable.of(RegistrationFact.R_LIST) instanceof RList.Agreed shown) {
      run.showed(variable, shown, report);
    }
  }
}
