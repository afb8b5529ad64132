// Generated from SetAgreement_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.agreement;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of SetAgreement_decls. */
public sealed interface AgreementAction extends Action {

  record propose(RobotId i, String v) implements AgreementAction {}

  record choose(String v) implements AgreementAction {}

  record decide(RobotId i) implements AgreementAction {}

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
