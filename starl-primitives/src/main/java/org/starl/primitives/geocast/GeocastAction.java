// Generated from Geocast_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.geocast;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of Geocast_decls. */
public sealed interface GeocastAction extends Action {

  record dt(long delta_t) implements GeocastAction {}

  record do_geocast(String m, Area A, long bound) implements GeocastAction {}

  record deliver(String m, RobotId i) implements GeocastAction {}

  record move(RobotId i, Place p) implements GeocastAction {}

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
