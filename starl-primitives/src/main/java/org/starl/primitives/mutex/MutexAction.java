package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Mutex_decls}, under their names there. */
public sealed interface MutexAction extends Action {

  /** Whose it is. */
  RobotId i();

  /** Asks for access to {@code RS}. */
  record do_mutex(RobotId i, SortedSet<String> RS) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i, RS);
    }
  }

  /** Has access to {@code RS}. */
  record od_mutex(RobotId i, SortedSet<String> RS) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i, RS);
    }
  }

  /** Gives {@code RS} back. */
  record release(RobotId i, SortedSet<String> RS) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i, RS);
    }
  }

  /** Its request ends without access. */
  record withdraw(RobotId i) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Its program begins anew, after a crash. */
  record restart(RobotId i) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Its program says in which sections its body may stand. */
  record stands_in(RobotId i, SortedSet<String> RS) implements MutexAction {
    @Override
    public List<Object> args() {
      return List.of(i, RS);
    }
  }
}
