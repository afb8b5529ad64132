package org.starl.primitives.ledger;

import java.util.SortedMap;
import java.util.SortedSet;
import org.starl.gvh.GvhVariable;
import org.starl.id.RobotId;
import org.starl.primitives.StarLPrimitive;

/**
 * The task ledger for apps. A call returns at once; {@code await(call::isDone)} and look at its outcome.
 * No call throws for what a program cannot know. Strand only.
 *
 * @param <T> what is to be done
 */
public interface LedgerPrim<T> extends StarLPrimitive {

  /**
   * Whether the log has the start of this robot's program. Before that {@link #tasks} and {@link #held}
   * are empty, and calls wait. Afterwards they have all that earlier programs of this
   * robot have claimed, begun and finished.
   */
  GvhVariable<Boolean> ready();

  /**
   * The tasks that are not finished, as far as this robot knows: the log up to some entry, which may be
   * old. A copy.
   */
  SortedMap<TaskId, LedgerTask<T>> tasks();

  /** The tasks that this robot has claimed or begun, also with an earlier program. */
  GvhVariable<SortedSet<TaskId>> held();

  /** The number of the latest task of a source; 0 before the first. */
  long added(String source);

  /**
   * Adds a task. Any number of robots may add the same one: it is in the ledger once. DONE as well if it
   * is finished already; LATE if another task has this name. A task waits until the one before it of its
   * source is added, and while there are 65,535 tasks or sources of tasks.
   *
   * @param what in at most 200 bytes
   * @throws IllegalArgumentException if the shape does not write {@code what}, or in more bytes
   */
  LedgerCall add(TaskId task, T what);

  /** Claims an open task: until this robot begins it, gives it back, restarts or is silent for a lease. */
  LedgerCall claim(TaskId task);

  /**
   * The point of no return of a task that this program has claimed, such as goods that are taken aboard.
   * If DONE, this robot alone may do the task, and no time ends that. Otherwise it must not.
   */
  LedgerCall begin(TaskId task);

  /** The task that this robot has begun is done. DONE: it is finished, for ever. */
  LedgerCall finish(TaskId task);

  /** Opens a task that this robot has claimed. DONE: it has no claim; LATE: it has begun the task. */
  LedgerCall giveBack(TaskId task);

  /**
   * Opens a task that any robot has begun. The application answers for it: the task is done a second time
   * unless that robot has not done it, and will not.
   */
  LedgerCall reopen(TaskId task);

  /**
   * Whether the robot that holds a task has been silent for a lease, so that it is dead or out of reach.
   * Only voters hear that; false on others. It may be wrong.
   */
  boolean isSilent(RobotId holder);
}
