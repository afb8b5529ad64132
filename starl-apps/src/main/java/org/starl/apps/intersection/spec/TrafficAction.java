// Generated from Traffic_decls.starl by 'starl compile': change that file instead.
package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of Traffic_decls. */
public sealed interface TrafficAction extends Action {

  record dt(long delta_t) implements TrafficAction {}

  record arrive(ProcessId i) implements TrafficAction {}

  record do_register(ProcessId i) implements TrafficAction {}

  record decide(SortedSet<ProcessId> L) implements TrafficAction {}

  record learn(ProcessId i, long n) implements TrafficAction {}

  record do_mutex(ProcessId i, SortedSet<String> RS) implements TrafficAction {}

  record od_mutex(ProcessId i, SortedSet<String> RS) implements TrafficAction {}

  /** into the next zone, or out of the last one */
  record advance(ProcessId i) implements TrafficAction {}

  record release(ProcessId i, SortedSet<String> RS) implements TrafficAction {}

  record unregister(ProcessId i) implements TrafficAction {}

  /** the request ends without access; i may ask again */
  record withdraw(ProcessId i) implements TrafficAction {}

  /** i acts no more; what it held is kept */
  record give_up(ProcessId i) implements TrafficAction {}

  /** the car of i, which has crashed, is taken off the road */
  record towed(ProcessId i) implements TrafficAction {}

  /** the car of j goes on as i */
  record restart(ProcessId i, ProcessId j) implements TrafficAction {}

  /** the program says where its body stands */
  record stands_in(ProcessId i, SortedSet<String> RS) implements TrafficAction {}

  /** the first zone of its way is behind it, and not asked for again */
  record skip(ProcessId i) implements TrafficAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case dt a -> List.of(a.delta_t);
      case arrive a -> List.of(a.i);
      case do_register a -> List.of(a.i);
      case decide a -> List.of(a.L);
      case learn a -> List.of(a.i, a.n);
      case do_mutex a -> List.of(a.i, a.RS);
      case od_mutex a -> List.of(a.i, a.RS);
      case advance a -> List.of(a.i);
      case release a -> List.of(a.i, a.RS);
      case unregister a -> List.of(a.i);
      case withdraw a -> List.of(a.i);
      case give_up a -> List.of(a.i);
      case towed a -> List.of(a.i);
      case restart a -> List.of(a.i, a.j);
      case stands_in a -> List.of(a.i, a.RS);
      case skip a -> List.of(a.i);
    };
  }
}
