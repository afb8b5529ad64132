// Generated from Mutex_group_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of Mutex_group_decls. */
public sealed interface MutexGroupAction extends Action {

  record do_mutex(ProcessId i, SortedSet<String> RS, SortedSet<ProcessId> P)
      implements MutexGroupAction {}

  /** a later list, while i waits */
  record known(ProcessId i, SortedSet<ProcessId> P) implements MutexGroupAction {}

  record od_mutex(ProcessId i, SortedSet<String> RS) implements MutexGroupAction {}

  record release(ProcessId i, SortedSet<String> RS) implements MutexGroupAction {}

  record withdraw(ProcessId i) implements MutexGroupAction {}

  /** i's program begins anew, or others have given i up */
  record restart(ProcessId i) implements MutexGroupAction {}

  /** i is the process of j's robot from now on */
  record take_over(ProcessId i, ProcessId j) implements MutexGroupAction {}

  record stands_in(ProcessId i, SortedSet<String> RS) implements MutexGroupAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_mutex a -> List.of(a.i, a.RS, a.P);
      case known a -> List.of(a.i, a.P);
      case od_mutex a -> List.of(a.i, a.RS);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case restart a -> List.of(a.i);
      case take_over a -> List.of(a.i, a.j);
      case stands_in a -> List.of(a.i, a.RS);
    };
  }
}
