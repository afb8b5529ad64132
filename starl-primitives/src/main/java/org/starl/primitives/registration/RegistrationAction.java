package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Registration_decls}, under their names there. */
public sealed interface RegistrationAction extends Action {

  /** An attempt to register begins. */
  record do_register(ProcessId i) implements RegistrationAction {}

  /** Asks to be removed. */
  record unregister(ProcessId i) implements RegistrationAction {}

  /** Its robot will request nothing with this id again. */
  record give_up(ProcessId i) implements RegistrationAction {}

  /** A fencer bounds what it may still hold. */
  record confine(ProcessId i) implements RegistrationAction {}

  /** The next list. */
  record decide(SortedSet<ProcessId> L) implements RegistrationAction {}

  /** Learns list {@code n}. */
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
