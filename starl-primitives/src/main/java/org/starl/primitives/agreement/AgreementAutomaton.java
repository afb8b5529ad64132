// Generated from SetAgreement_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.agreement;

import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Sets;

/**
 * The automaton SetAgreement_decls, executable.
 *
 * <p>Agreement on one value, once and for all: the abstract specification. The paper calls the core
 * of Registration a "set-valued distributed consensus" (section 4.3); this is that consensus, over
 * any values.
 *
 * <p>Anybody may propose any values. One of those proposed is chosen, at some instant that nobody
 * need know of; whoever is told is told that one. A process that restarts has forgotten what it was
 * told.
 *
 * <p>Nothing is assumed. Java: org.starl.primitives.agreement.SetAgreement; `proposed' and `value'
 * are what is true of the whole system, `decided(i)' is what i knows; this automaton:
 * AgreementAutomaton; monitors: AgreementSpec, AgreementConformance.
 */
public final class AgreementAutomaton
    implements Automaton<AgreementAutomaton.States, AgreementAction> {

  /** The theory's name. */
  public static final String SET_AGREEMENT_DECLS = "SetAgreement_decls";

  /**
   * The states.
   *
   * @param value what is chosen; none: nothing yet
   */
  public record States(
      SortedSet<String> proposed, Lift<String> value, Fun<RobotId, Lift<String>> decided) {}

  @Override
  public String theory() {
    return SET_AGREEMENT_DECLS;
  }

  @Override
  public States start() {
    return new States(Sets.emptyset(), new Lift.bottom<>(), Fun.always(new Lift.bottom<>()));
  }

  @Override
  public Enabled enabled(AgreementAction action, States s) {
    return switch (action) {
      case AgreementAction.propose a -> Enabled.TRUE;
      case AgreementAction.choose a ->
          Enabled.when("value = none", !s.value.isUp(), () -> "value = " + s.value)
              .and("v in proposed", s.proposed.contains(a.v()), () -> "proposed = " + s.proposed);
      case AgreementAction.decide a ->
          Enabled.when("value != none", s.value.isUp(), () -> "value = " + s.value);
      case AgreementAction.restart a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(AgreementAction action, States s) {
    return switch (action) {
      case AgreementAction.propose a -> new States(Sets.add(a.v(), s.proposed), s.value, s.decided);
      case AgreementAction.choose a -> new States(s.proposed, new Lift.up<>(a.v()), s.decided);
      case AgreementAction.decide a ->
          new States(s.proposed, s.value, s.decided.with(a.i(), s.value));
      case AgreementAction.restart a ->
          new States(s.proposed, s.value, s.decided.with(a.i(), new Lift.bottom<>()));
    };
  }
}
