package org.starl.primitives.geocast;

import java.util.List;
import java.util.SortedSet;
import org.starl.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Geocast_decls}, under their names there. */
public sealed interface GeocastAction extends Action {

  /** Time passes, in ns. */
  record dt(long delta_t) implements GeocastAction {
    @Override
    public List<Object> args() {
      return List.of(delta_t);
    }
  }

  /**
   * Is sent to all in an area.
   *
   * @param A what the area is known by: a place is in it if it has this
   * @param bound for how long, in ns
   */
  record do_geocast(String m, String A, long bound) implements GeocastAction {
    @Override
    public List<Object> args() {
      return List.of(m, A, bound);
    }
  }

  /** Is handed the message. */
  record deliver(String m, RobotId i) implements GeocastAction {
    @Override
    public List<Object> args() {
      return List.of(m, i);
    }
  }

  /**
   * Its body is at another place.
   *
   * @param p by what the areas are known that it is in
   */
  record move(RobotId i, SortedSet<String> p) implements GeocastAction {
    @Override
    public List<Object> args() {
      return List.of(i, p);
    }
  }

  /** Its program begins anew, and has forgotten what it was handed. */
  record restart(RobotId i) implements GeocastAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }
}
