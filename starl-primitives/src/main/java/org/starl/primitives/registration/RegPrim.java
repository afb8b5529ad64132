package org.starl.primitives.registration;

import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/** Registration as an app sees it (paper, section 4.3). Strand only. */
public interface RegPrim extends StarLPrimitive {

  /**
   * Asks to be in. {@link #rList} is null at once, and a list that lists this robot once registered;
   * or {@link #failed} becomes true at the deadline.
   *
   * <p>If others took this robot for crashed, wrongly, it is not registered any more, {@link #rList} is
   * null and {@link #failed} told, and this is how it comes back.
   *
   * @throws IllegalStateException if this robot is registered, registering or unregistering
   */
  void do_register();

  /** The same as {@code rList().get()}. */
  RList getList();

  /**
   * The agreed list. Null also while a newer one is known to be on its way, for a bounded time: no
   * mutex depends on it, which reads the views themselves.
   */
  GvhVariable<RList> rList();

  /** The number of the latest list that this robot has learned; 0 before any. */
  long ts();

  /**
   * Whether the latest call was given up at its deadline, or others have put this robot out since: call
   * {@link #do_register} again.
   */
  GvhVariable<Boolean> failed();

  /**
   * Asks to be out. A request that waits in the mutex over this registration fails. {@link #rList} is
   * null at once. If it is given up, {@link #failed} is told: call it again, or {@link #do_register},
   * which leaves the old id behind. Right also for a robot that others have taken for crashed.
   *
   * @throws IllegalStateException if this robot is not registered, or holds something
   */
  void unregister();

  /**
   * Whether the latest {@link #unregister} has come to its end: the latest list lacks this robot, and
   * those concerned have been told as far as they can be reached. A robot that goes away before may
   * leave others waiting for it for some seconds.
   */
  boolean isUnregistered();
}
