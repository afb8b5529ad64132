package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;

/** What participants of one mutex say to each other. Each may be lost, late, doubled, overtaken. */
sealed interface MutexMessage {

  ProcessId from();

  /** The participant that is meant: a robot may answer under an older id as well. */
  ProcessId to();

  /**
   * {@code from} asks for {@code want}. Repeated until its {@link Ok} comes or the request ends.
   *
   * @param num the request's number, from 1; an id never uses one twice
   * @param admittedBy the number of the view that admitted {@code from}
   * @param ts the request's logical time; the lower one goes first
   */
  record Req(
      ProcessId from, ProcessId to, long num, long admittedBy, long ts, SortedSet<String> want)
      implements MutexMessage {}

  /** {@code from} grants request {@code num} of {@code to}, and no other. */
  record Ok(ProcessId from, ProcessId to, long num) implements MutexMessage {}

  /** What {@code from} still holds or wants of its request {@code num}; nothing: it is over. */
  record Rem(ProcessId from, ProcessId to, long num, SortedSet<String> left)
      implements MutexMessage {}

  /**
   * {@code from} is alive, and keeps its answer to request {@code num} of {@code to} back: says so
   * to one who has asked twice.
   */
  record Noted(ProcessId from, ProcessId to, long num) implements MutexMessage {}

  /**
   * {@code from} suspects that {@code suspect} has crashed.
   *
   * @param admittedBy the number of the view that admitted {@code suspect}
   */
  record FenceQ(ProcessId from, ProcessId to, ProcessId suspect, long admittedBy)
      implements MutexMessage {}

  /**
   * {@code from} grants {@code suspect} nothing more, for ever, and vouches that {@code suspect},
   * who needs its consent, holds no more than {@code open}.
   */
  record Fence(ProcessId from, ProcessId to, ProcessId suspect, SortedSet<String> open)
      implements MutexMessage {}

  /** {@code from} has given up {@code to}, which should register anew. */
  record Fenced(ProcessId from, ProcessId to) implements MutexMessage {}
}
