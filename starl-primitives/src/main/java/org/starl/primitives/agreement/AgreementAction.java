package org.starl.primitives.agreement;

import java.util.List;
import org.starl.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code SetAgreement_decls}, under their names there. */
public sealed interface AgreementAction extends Action {

  /** Works for a decision on {@code v}. */
  record propose(RobotId i, String v) implements AgreementAction {
    @Override
    public List<Object> args() {
      return List.of(i, v);
    }
  }

  /** Is decided on, which nobody need know of. */
  record choose(String v) implements AgreementAction {
    @Override
    public List<Object> args() {
      return List.of(v);
    }
  }

  /** Learns what is decided on. */
  record decide(RobotId i) implements AgreementAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Its program begins anew, knowing nothing. */
  record restart(RobotId i) implements AgreementAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }
}
