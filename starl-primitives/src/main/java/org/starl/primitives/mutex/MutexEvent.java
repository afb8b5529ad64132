package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.View;

/** What a trace tells of a mutex; monitors and viewers read it with {@link MutexTrace#read}. */
public sealed interface MutexEvent {

  /** Whose step it was. */
  ProcessId who();

  /**
   * A request begins.
   *
   * @param num its number among those of {@code who}
   * @param ts its logical time
   * @param known whose consent it needs
   */
  record DoMutex(
      ProcessId who, long num, long ts, SortedSet<String> want, SortedSet<ProcessId> known)
      implements MutexEvent {}

  /** Access was granted to all of {@code held}. */
  record OdMutex(ProcessId who, long num, SortedSet<String> held) implements MutexEvent {}

  /** {@code given} was given back, {@code left} is still held. */
  record Release(ProcessId who, long num, SortedSet<String> given, SortedSet<String> left)
      implements MutexEvent {}

  /** The request ended without access. */
  record Withdraw(ProcessId who, long num, MutexFailure why) implements MutexEvent {}

  /** {@code who} consents to request {@code num} of {@code to}. */
  record Grant(ProcessId who, ProcessId to, long num) implements MutexEvent {}

  /** {@code who} has learned {@code view}. */
  record Learned(ProcessId who, View view) implements MutexEvent {}

  /**
   * {@code who} grants {@code suspect} nothing more, for ever.
   *
   * @param open what {@code suspect} may still hold, as far as {@code who} has granted it
   */
  record Fence(ProcessId who, ProcessId suspect, SortedSet<String> open) implements MutexEvent {}

  /**
   * The robot of {@code who} says that its program has started anew, so that its participants of
   * earlier starts are dead, and that its body is in no other section than these.
   */
  record StandsIn(ProcessId who, SortedSet<String> sections) implements MutexEvent {}

  /** Whose consent the request needs, or would need if it began now, is this from now on. */
  record Known(ProcessId who, long num, SortedSet<ProcessId> known) implements MutexEvent {}
}
