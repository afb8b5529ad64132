// Generated from MutexProtocol_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of MutexProtocol_decls. */
public sealed interface ProtocolAction extends Action {

  /** a set, or a sequence */
  record request(ProcessId i, SortedSet<String> RS, SortedSet<ProcessId> P, boolean in_parts)
      implements ProtocolAction {}

  /**
   * A later list, while i waits. Who holds zones already asks nobody else: who has come since has
   * it on its own list.
   */
  record known(ProcessId i, SortedSet<ProcessId> P) implements ProtocolAction {}

  /** a later list leaves j out */
  record forget(ProcessId i, ProcessId j) implements ProtocolAction {}

  record grant(ProcessId j, ProcessId i, long t, String z) implements ProtocolAction {}

  /** all its zones, or some of a sequence */
  record enter(ProcessId i, SortedSet<String> G) implements ProtocolAction {}

  record release(ProcessId i, SortedSet<String> RS) implements ProtocolAction {}

  /** what it holds stays held */
  record withdraw(ProcessId i) implements ProtocolAction {}

  /** f grants i nothing any more */
  record fence(ProcessId f, ProcessId i) implements ProtocolAction {}

  /** j does not hold z, and will not */
  record vouch(ProcessId f, ProcessId j, ProcessId i, long t, String z) implements ProtocolAction {}

  /** hears of a time */
  record witness(ProcessId i, long t) implements ProtocolAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case request a -> List.of(a.i, a.RS, a.P, a.in_parts);
      case known a -> List.of(a.i, a.P);
      case forget a -> List.of(a.i, a.j);
      case grant a -> List.of(a.j, a.i, a.t, a.z);
      case enter a -> List.of(a.i, a.G);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case fence a -> List.of(a.f, a.i);
      case vouch a -> List.of(a.f, a.j, a.i, a.t, a.z);
      case witness a -> List.of(a.i, a.t);
    };
  }
}
