package org.starl.primitives.registration;

import org.jspecify.annotations.Nullable;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.platform.Waits;
import org.starl.primitives.StarLPrimitive;

/** The registration interface for apps (paper, section 4.3). Strand only. */
public interface RegPrim extends StarLPrimitive {

  /**
   * Asks to be registered. {@link #rList} is null at once, and a list with this robot once it is
   * registered; or {@link #failed} becomes true at the deadline.
   *
   * <p>If other robots wrongly took this one for crashed, it is no longer registered: {@link #rList} is
   * null and {@link #failed} is true. A call of this method registers it again. It has no effect on a
   * robot that is registered or registering: {@link #rList} may be null for a while although it is.
   *
   * @throws IllegalStateException while this robot unregisters
   */
  void do_register();

  /**
   * Registers this robot and waits: calls {@link #do_register} again after each failure. Only from
   * {@code callStarL}.
   *
   * @param timeoutMs how long at most, above 0
   * @return whether this robot is registered
   */
  boolean register(long timeoutMs);

  /** The same for an app that suspends: {@code await(reg.registering(60_000))}. */
  Waits<Boolean> registering(long timeoutMs);

  /**
   * The agreed list, or null if there is none, as in the paper's Figure 4: {@code if (reg.getList()
   * != null)}. {@link #ts} is its time stamp.
   */
  @Nullable Participants getList();

  /** The agreed list; empty where {@link #getList} is null. */
  default Participants listOrEmpty() {
    Participants list = getList();
    return list == null ? Participants.of() : list;
  }

  /**
   * The agreed list with its time stamp. Also null while a newer one is expected, for a bounded time. The mutex does not
   * depend on this: it reads the views themselves.
   */
  GvhVariable<RList> rList();

  /** The number of the latest list that this robot has learned; 0 before any. */
  long ts();

  /**
   * Whether the latest call was given up at its deadline, or other robots have removed this one since:
   * call {@link #do_register} again.
   */
  GvhVariable<Boolean> failed();

  /**
   * Asks to be removed. A request that waits in the mutex over this registration fails. {@link #rList}
   * is null at once. If the call is given up, {@link #failed} becomes true: call it again, or {@link
   * #do_register}, which drops the old id. A robot that was taken for crashed may call it too, and one that
   * has unregistered: a call that was given up may end after all.
   *
   * @throws IllegalStateException if this robot is not registered, or holds a section
   */
  void unregister();

  /**
   * Whether the latest {@link #unregister} is complete: this robot is not on the latest list, and all
   * reachable robots concerned know that list. If a robot goes away before, others may wait for it for
   * some seconds.
   */
  boolean isUnregistered();
}
