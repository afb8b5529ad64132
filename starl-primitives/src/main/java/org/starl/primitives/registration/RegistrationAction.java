package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Registration_decls}, under their names there. */
public sealed interface RegistrationAction extends Action {

  /** An attempt to take part begins. */
  record do_register(ProcessId i) implements RegistrationAction {}

  /** It asks out. */
  record unregister(ProcessId i) implements RegistrationAction {}

  /** Its own robot requests nothing under this id any more. */
  record give_up(ProcessId i) implements RegistrationAction {}

  /** Somebody vouches for what it may still hold. */
  record confine(ProcessId i) implements RegistrationAction {}

  /** The next list. */
  record decide(SortedSet<ProcessId> L) implements RegistrationAction {}

  /** It learns list {@code n}. */
  record learn(ProcessId i, long n) implements RegistrationAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_register a -> List.of(a.i);
      case unregister a -> List.of(a.i);
      case give_up a -> List.of(a.i);
      case confine a -> List.of(a.i);
      case decide a -> List.of(a.L);
      case learn a -> List.of(a.i, a.n);
    };
  }
}
