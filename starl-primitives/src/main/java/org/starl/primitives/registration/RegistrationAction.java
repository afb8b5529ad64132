// Generated from Registration_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of Registration_decls. */
public sealed interface RegistrationAction extends Action {

  record do_register(ProcessId i) implements RegistrationAction {}

  record unregister(ProcessId i) implements RegistrationAction {}

  /** i's own robot requests nothing under this id any more */
  record give_up(ProcessId i) implements RegistrationAction {}

  /** somebody vouches for what i may still hold */
  record confine(ProcessId i) implements RegistrationAction {}

  /** the next list */
  record decide(SortedSet<ProcessId> L) implements RegistrationAction {}

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
