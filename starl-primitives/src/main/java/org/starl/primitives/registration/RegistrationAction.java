package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedSet;
import org.starl.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Registration_decls}, under their names there. */
public sealed interface RegistrationAction extends Action {

  /** An attempt to take part begins. */
  record do_register(ProcessId i) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** It asks out. */
  record unregister(ProcessId i) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Its own robot requests nothing under this id any more. */
  record give_up(ProcessId i) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Somebody vouches for what it may still hold. */
  record confine(ProcessId i) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** The next list. */
  record decide(SortedSet<ProcessId> L) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(L);
    }
  }

  /** It learns list {@code n}. */
  record learn(ProcessId i, long n) implements RegistrationAction {
    @Override
    public List<Object> args() {
      return List.of(i, n);
    }
  }
}
