// Generated from Mutex_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of Mutex_decls. */
public sealed interface MutexAction extends Action {

  record do_mutex(ProcessId i, SortedSet<String> RS) implements MutexAction {}

  /** access is granted */
  record od_mutex(ProcessId i, SortedSet<String> RS) implements MutexAction {}

  record release(ProcessId i, SortedSet<String> RS) implements MutexAction {}

  /** the request ends without access: failed */
  record withdraw(ProcessId i) implements MutexAction {}

  /** i's program begins anew, after a crash */
  record restart(ProcessId i) implements MutexAction {}

  /** i is the process of j's robot from now on */
  record take_over(ProcessId i, ProcessId j) implements MutexAction {}

  /** the program says where its body stands */
  record stands_in(ProcessId i, SortedSet<String> RS) implements MutexAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_mutex a -> List.of(a.i, a.RS);
      case od_mutex a -> List.of(a.i, a.RS);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case restart a -> List.of(a.i);
      case take_over a -> List.of(a.i, a.j);
      case stands_in a -> List.of(a.i, a.RS);
    };
  }
}
