package org.starl.primitives.geocast;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Geocast_decls}, under their names there. */
public sealed interface GeocastAction extends Action {

  /** Time passes, in ns. */
  record dt(long delta_t) implements GeocastAction {}

  /**
   * Is sent to all in an area.
   *
   * @param A what the area is known by: a place is in it if it has this
   * @param bound for how long, in ns
   */
  record do_geocast(String m, String A, long bound) implements GeocastAction {}

  /** Is handed the message. */
  record deliver(String m, RobotId i) implements GeocastAction {}

  /**
   * Its body is at another place.
   *
   * @param p by what the areas are known that it is in
   */
  record move(RobotId i, SortedSet<String> p) implements GeocastAction {}

  /** Its program begins anew, and has forgotten what it was handed. */
  record restart(RobotId i) implements GeocastAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case dt a -> List.of(a.delta_t);
      case do_geocast a -> List.of(a.m, a.A, a.bound);
      case deliver a -> List.of(a.m, a.i);
      case move a -> List.of(a.i, a.p);
      case restart a -> List.of(a.i);
    };
  }
}
