package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.View;

/** An event of a mutex in a trace; monitors and viewers read it with {@link MutexTrace#read}. */
public sealed interface MutexEvent {

  /** The participant that took the step. */
  ProcessId who();

  /**
   * A request begins.
   *
   * @param num the number of the request, counted for each {@code who}
   * @param ts the logical time of the request
   * @param known the participants whose consent it needs
   */
  record DoMutex(
      ProcessId who, long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known)
      implements MutexEvent {}

  /** Access to {@code held} was granted. */
  record OdMutex(ProcessId who, long num, SortedSet<String> held) implements MutexEvent {}

  /** {@code given} was released, {@code left} is still held. */
  record Release(ProcessId who, long num, SortedSet<String> given, SortedSet<String> left)
      implements MutexEvent {}

  /** The request ended without access. */
  record Withdraw(ProcessId who, long num, MutexFailure why) implements MutexEvent {}

  /** {@code who} consents to request {@code num} of {@code to}. */
  record Grant(ProcessId who, ProcessId to, long num) implements MutexEvent {}

  /** {@code who} has learned {@code view}. */
  record Learned(ProcessId who, View view) implements MutexEvent {}

  /**
   * {@code who} never grants {@code suspect} anything again.
   *
   * @param open the sections that {@code who} has granted and {@code suspect} may still hold
   */
  record Fence(ProcessId who, ProcessId suspect, SortedSet<String> open) implements MutexEvent {}

  /**
   * The robot of {@code who} declares, after a restart of its program, that its body is only in
   * these sections. Its participants of earlier starts are dead.
   */
  record StandsIn(ProcessId who, SortedSet<String> sections) implements MutexEvent {}

  /** From now on a request needs, or would need, the consent of {@code known}. */
  record Known(ProcessId who, long num, SortedSet<ProcessId> known) implements MutexEvent {}
}
