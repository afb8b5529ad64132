package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Mutex_decls}, under their names there. */
public sealed interface MutexAction extends Action {

  /** The robot. */
  RobotId i();

  /** Requests access to {@code RS}. */
  record do_mutex(RobotId i, SortedSet<String> RS) implements MutexAction {}

  /** Has access to {@code RS}. */
  record od_mutex(RobotId i, SortedSet<String> RS) implements MutexAction {}

  /** Releases {@code RS}. */
  record release(RobotId i, SortedSet<String> RS) implements MutexAction {}

  /** Its request ends without access. */
  record withdraw(RobotId i) implements MutexAction {}

  /** Its program restarts after a crash. */
  record restart(RobotId i) implements MutexAction {}

  /** Its program declares the sections in which its body may be. */
  record stands_in(RobotId i, SortedSet<String> RS) implements MutexAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_mutex a -> List.of(a.i, a.RS);
      case od_mutex a -> List.of(a.i, a.RS);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case restart a -> List.of(a.i);
      case stands_in a -> List.of(a.i, a.RS);
    };
  }
}
