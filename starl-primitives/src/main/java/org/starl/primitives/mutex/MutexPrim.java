package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.SortedSet;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.primitives.StarLPrimitive;

/**
 * Mutual exclusion as an app sees it (paper, section 4.5): access to a set of sections, all at the
 * same time, given back one by one or together. Strand only.
 *
 * <pre>{@code
 * mux.do_mutex(List.of("A", "C"));
 * await(() -> mux.crit().get() || mux.failed().get());
 * if (mux.crit().get()) {
 *   // use
 *   mux.release("A", "C");
 * }
 * }</pre>
 */
public interface MutexPrim extends StarLPrimitive {

  /**
   * Requests access to {@code sections}. {@link #crit} becomes true when access is granted, or
   * {@link #failed} when it will not be; until then both are false. Either may happen at once.
   *
   * @param sections 1 to 32 names, each 1 to 32 of {@code A-Z a-z 0-9 _ - . :}
   * @throws IllegalStateException while waiting for, or holding, what was asked for before
   * @throws IllegalArgumentException if {@code sections} is no such set
   */
  void do_mutex(Collection<String> sections);

  /**
   * As {@link #do_mutex(Collection)}, exclusive with every robot in {@code plist} (paper, section
   * 3.2).
   *
   * <p>The request asks every robot in {@code plist} that can hold a section, and also all others
   * that this robot knows: if each robot asked only its own list, two requests might never meet. A
   * robot that has joined later asks this one, and one that has left, or never registered, holds
   * nothing. So {@code plist} may be an older list of the same registration, and a short list does
   * not narrow exclusion.
   *
   * @throws IllegalArgumentException also if {@code plist} does not name this robot, or names one
   *     that is outside a fixed group: such a robot could not be excluded
   */
  void do_mutex(Collection<String> sections, Participants plist);

  /** Whether access was granted and something of it is still held; {@code crit().get()}. */
  boolean od_mutex();

  /** Whether this robot has access to all that it asked for and has not given back. */
  GvhVariable<Boolean> crit();

  /** Whether the latest request ended without access. */
  GvhVariable<Boolean> failed();

  /** Why it did. */
  GvhVariable<MutexFailure> failure();

  /**
   * Gives back {@code sections}.
   *
   * @throws IllegalArgumentException if they are none, or not all held
   */
  void release(Collection<String> sections);

  /** The same. */
  void release(String... sections);

  /** Gives up what it waits for: {@link #failed} becomes true. If it does not wait, nothing. */
  void withdraw();

  /**
   * For a robot whose program has started anew: who it was before may still be thought to hold what
   * it held. This is its own word that its body is in no other section than these; say less as it
   * goes on, and in the end nothing. What it says it stands in is its own to ask for.
   */
  void standsIn(Collection<String> sections);

  /** What this robot has access to now. */
  SortedSet<String> held();

  /**
   * Ends this robot's part. A request is withdrawn; what is held stays held for ever, as by a robot
   * that crashed: release it before. Nobody who still needs this robot's consent gets it, so
   * unregister before. An instance cannot be opened again before the robot's program restarts.
   */
  @Override
  void close();
}
