package org.starl.primitives.agreement;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code SetAgreement_decls}, under their names there. */
public sealed interface AgreementAction extends Action {

  /** Works for a decision on {@code v}. */
  record propose(RobotId i, String v) implements AgreementAction {}

  /** Is decided on, which nobody need know of. */
  record choose(String v) implements AgreementAction {}

  /** Learns what is decided on. */
  record decide(RobotId i) implements AgreementAction {}

  /** Its program begins anew, knowing nothing. */
  record restart(RobotId i) implements AgreementAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case propose a -> List.of(a.i, a.v);
      case choose a -> List.of(a.v);
      case decide a -> List.of(a.i);
      case restart a -> List.of(a.i);
    };
  }
}
