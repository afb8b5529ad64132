package org.starl.primitives.mutex;

import java.util.SortedSet;
import org.starl.id.ProcessId;

/** Messages of a mutex. Each may be lost, late, duplicated or reordered. */
sealed interface MutexMessage {

  ProcessId from();

  /** The addressed participant: a robot may also answer under an older id. */
  ProcessId to();

  /**
   * {@code from} requests {@code want}. Repeated until the {@link Ok} arrives or the request ends.
   *
   * @param num the request's number, from 1; an id never uses a number twice
   * @param admittedBy the number of the view that admitted {@code from}
   * @param ts the request's logical time; the lower one goes first
   */
  record Req(
      ProcessId from, ProcessId to, long num, long admittedBy, long ts, SortedSet<String> want)
      implements MutexMessage {}

  /** {@code from} grants request {@code num} of {@code to}, and no other request. */
  record Ok(ProcessId from, ProcessId to, long num) implements MutexMessage {}

  /** The sections of request {@code num} that {@code from} still holds or wants; none: it ended. */
  record Rem(ProcessId from, ProcessId to, long num, SortedSet<String> left)
      implements MutexMessage {}

  /**
   * {@code from} is alive, and defers its answer to request {@code num} of {@code to}. Sent when
   * the request is repeated.
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
   * {@code from} never grants {@code suspect} anything again. {@code suspect} needs its consent,
   * and so holds at most {@code open}.
   */
  record Fence(ProcessId from, ProcessId to, ProcessId suspect, SortedSet<String> open)
      implements MutexMessage {}

  /** {@code from} has fenced {@code to}, which should register again. */
  record Fenced(ProcessId from, ProcessId to) implements MutexMessage {}
}
