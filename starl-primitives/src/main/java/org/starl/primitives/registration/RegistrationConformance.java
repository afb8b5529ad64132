package org.starl.primitives.registration;

import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replays;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every registration is a run of the theory {@code Registration_decls}: the lemma is its
 * name. What happens is taken for an action of the theory so:
 *
 * <pre>
 * event                                  action
 * first_view V                           do_register(i) for each i in V that has not asked: the
 *                                        deployment has asked for it
 * do_register i                          do_register(i), and learn(i, n) if its robot knows list n
 * unregister i                           unregister(i), by its own robot's word
 * give_up i                              give_up(i), by its own robot's word; a stutter if i has not
 *                                        asked, since nobody lists it then
 * confine i sections fencers             confine(i), by a fencer's or its own robot's word
 * view n: L, as the first to know it     decide(L)
 * view n: L                              learn(i, n), i being the id that its robot asked for last,
 *                                        or was given; rList(i) is L
 * rList n: robots                        stutter; rList(i) is of these robots, and ts(i) is n
 * all other events                       stutter
 * </pre>
 *
 * <p>A list is those who are free in a view; a ghost was confined, so it is {@code gone}, and its
 * sections are no matter of this theory. Nobody tells when a view is decided. It is taken for decided
 * when the first robot knows it, but not before the views of all lower numbers: what is known too
 * early waits for them, and a number that nobody has known by the end of the run, or 256 numbers
 * later, is taken to be as the one before it. That is a run of the theory if any is, since {@code
 * asked} and {@code gone} only grow, and that list lets nobody in.
 *
 * <p>A robot whose program has not asked for anything learns for nobody: an acceptor, perhaps. What
 * is kept are the ids of all attempts, and the latest 256 lists.
 */
public final class RegistrationConformance extends Conformance {

  private final Replays<States, RegistrationAction> replays;
  private final Map<String, RegistrationRun> runs = new TreeMap<>();

  public RegistrationConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  public RegistrationConformance(Steps<States, RegistrationAction> steps) {
    super(RegistrationAutomaton.REGISTRATION_DECLS, "every registration");
    replays = new Replays<>(new RegistrationAutomaton(), steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Action action when RegistrationTrace.isRegistration(action.source()) ->
          acted(action, run(action.source()), report);
      case Variable variable when RegistrationTrace.isRegistration(variable.source()) ->
          changed(variable, run(variable.source()), report);
      default -> {
        // A stutter.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    runs.values().forEach(run -> run.finish(report));
  }

  private RegistrationRun run(String source) {
    return runs.computeIfAbsent(source, name -> new RegistrationRun(replays.of(name)));
  }

  private static void acted(Action action, RegistrationRun run, Report report) {
    switch (action.name()) {
      case RegistrationTrace.FIRST_VIEW ->
          run.isGiven(action, View.parse(action.args().get(0)), report);
      case RegistrationTrace.DO_REGISTER -> run.asks(action, id(action), report);
      case RegistrationTrace.UNREGISTER -> run.unregisters(action, id(action), report);
      case RegistrationTrace.GIVE_UP -> run.givesUp(action, id(action), report);
      case RegistrationTrace.CONFINE -> {
        Confinement confinement = Confinement.parse(action.args());
        ProcessId who = confinement.who();
        if (!confinement.fencers().isEmpty() || who.robot().equals(action.robot())) {
          run.step(action, new RegistrationAction.confine(who), report);
        }
      }
      default -> {
        // A stutter.
      }
    }
  }

  private static void changed(Variable variable, RegistrationRun run, Report report) {
    switch (variable.name()) {
      case RegistrationTrace.VIEW -> run.sees(variable, View.parse(variable.value()), report);
      case RegistrationTrace.R_LIST -> run.shows(variable, report);
      default -> {
        // A stutter.
      }
    }
  }

  private static ProcessId id(Action action) {
    return ProcessId.parse(action.args().get(0));
  }
}
