package org.starl.primitives.agreement;

import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;

/**
 * The theory {@code SetAgreement_decls}, as an executable automaton: agreement on one value, once. {@code PIDS} are
 * robots, {@code Values} the values' texts. {@link AgreementConformance} replays runs on it.
 */
public final class AgreementAutomaton
    implements Automaton<AgreementAutomaton.States, AgreementAction> {

  /** The theory's name. */
  public static final String SET_AGREEMENT_DECLS = "SetAgreement_decls";

  /**
   * The theory's states.
   *
   * @param proposed by any robot
   * @param value the decision
   * @param decided the decision, as a robot knows it
   */
  public record States(
      Fun<String, Boolean> proposed, Lift<String> value, Fun<RobotId, Lift<String>> decided) {}

  @Override
  public String theory() {
    return SET_AGREEMENT_DECLS;
  }

  @Override
  public States start() {
    return new States(Fun.always(false), new Lift.bottom<>(), Fun.always(new Lift.bottom<>()));
  }

  @Override
  public Enabled enabled(AgreementAction action, States s) {
    return switch (action) {
      case AgreementAction.propose a -> Enabled.TRUE;
      case AgreementAction.choose a ->
          Enabled.when("bottom?(value)", !s.value.isUp(), () -> "value = " + s.value.text())
              .and("proposed(v)", s.proposed.at(a.v()), () -> "no robot proposed " + a.v());
      case AgreementAction.decide a ->
          Enabled.when("up?(value)", s.value.isUp(), () -> "value = " + s.value.text());
      case AgreementAction.restart a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(AgreementAction action, States s) {
    return switch (action) {
      case AgreementAction.propose a ->
          new States(s.proposed.with(a.v(), true), s.value, s.decided);
      case AgreementAction.choose a -> new States(s.proposed, new Lift.up<>(a.v()), s.decided);
      case AgreementAction.decide a ->
          new States(s.proposed, s.value, s.decided.with(a.i(), s.value));
      case AgreementAction.restart a ->
          new States(s.proposed, s.value, s.decided.with(a.i(), new Lift.bottom<>()));
    };
  }
}
