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
   * A message is sent to all robots in an area.
   *
   * @param A the name of the area; a place is in the area if it contains this name
   * @param bound the length of the interval, in ns
   */
  record do_geocast(String m, String A, long bound) implements GeocastAction {}

  /** The robot receives the message. */
  record deliver(String m, RobotId i) implements GeocastAction {}

  /**
   * The robot's body moves to another place.
   *
   * @param p the names of the areas that contain the place
   */
  record move(RobotId i, SortedSet<String> p) implements GeocastAction {}

  /** The robot's program restarts, and forgets the messages that it received. */
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
