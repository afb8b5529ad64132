package org.starl.primitives.agreement;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code SetAgreement_decls}, under their names there. */
public sealed interface AgreementAction extends Action {

  /** Proposes {@code v}. */
  record propose(RobotId i, String v) implements AgreementAction {}

  /** {@code v} is decided on; no robot need know yet. */
  record choose(String v) implements AgreementAction {}

  /** Learns the decision. */
  record decide(RobotId i) implements AgreementAction {}

  /** Its program restarts and knows nothing. */
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
