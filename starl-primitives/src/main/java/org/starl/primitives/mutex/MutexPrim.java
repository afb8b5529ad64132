package org.starl.primitives.mutex;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.stream.Collectors;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Waits;
import org.starl.primitives.StarLPrimitive;
import org.starl.time.Time;

/**
 * The interface of mutual exclusion (paper, section 4.5): access to a set of sections, granted all
 * at once, released one by one or together. Strand only.
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
   * Requests access to {@code sections}. {@link #crit} becomes true when access is granted, {@link
   * #failed} when the request fails; until then both are false. Either may happen during this call.
   *
   * @param sections 1 to 32 names, each 1 to 32 of {@code A-Z a-z 0-9 _ - . :}; a name may end in a
   *     mode, which robots share, and its capacity: {@code aisle/east*2} (see {@link
   *     org.starl.primitives.membership.Sections})
   * @throws IllegalStateException while an earlier request waits or holds sections
   * @throws IllegalArgumentException if {@code sections} is not such a set, or names a section in two
   *     modes
   */
  void do_mutex(Collection<String> sections);

  /**
   * Like {@link #do_mutex(Collection)}, exclusive with every robot in {@code plist} (paper, section
   * 3.2).
   *
   * <p>The request asks every robot in {@code plist} that can hold a section, and also all others
   * that this robot knows: if each robot asked only its own list, two robots might not ask each
   * other. A robot that joins later asks this one, and a robot that has left, or never registered,
   * holds no section. So {@code plist} may be an older list of the same registration, and a short
   * list does not narrow exclusion.
   *
   * @throws IllegalArgumentException also if {@code plist} does not name this robot, or names a
   *     robot outside a fixed group: such a robot could not be excluded
   */
  void do_mutex(Collection<String> sections, Participants plist);

  /**
   * The same for a path: the names of its points are the sections (paper, Figure 4).
   *
   * @throws IllegalArgumentException as above
   */
  default void do_mutex(List<ItemPosition> path, Participants plist) {
    do_mutex(path.stream().map(ItemPosition::name).collect(Collectors.toList()), plist);
  }

  /**
   * Requests access to {@code sections} and waits for it: requests again after a failure, and
   * registers again where that is needed. Only from {@code callStarL}.
   *
   * <pre>{@code
   * if (mux.acquire(List.of("A", "C"), 60_000) == MutexFailure.NONE) {
   *   // use
   *   mux.release("A", "C");
   * }
   * }</pre>
   *
   * @param timeoutMs how long at most, above 0; then the request is withdrawn
   * @return {@link MutexFailure#NONE} if access was granted; else why the latest of its requests
   *     failed, or {@link MutexFailure#WITHDRAWN} if none did before the end
   * @throws IllegalStateException as {@link #do_mutex(Collection)}
   */
  MutexFailure acquire(Collection<String> sections, long timeoutMs);

  /** The same for an app that suspends: {@code await(mux.acquiring(listOf("A"), 60_000))}. */
  Waits<MutexFailure> acquiring(Collection<String> sections, long timeoutMs);

  /**
   * The robots that were given up as crashed and may still be in sections, as far as this robot has
   * learned: for each who it was, in which sections, and since when this robot knows. A request for
   * one of these sections fails with {@link MutexFailure#OCCUPIED}.
   */
  List<Occupant> occupants();

  /**
   * A robot that was given up as crashed and may still be in sections.
   *
   * @param sinceNs when this robot learned of it, by its clock
   */
  record Occupant(RobotId robot, SortedSet<String> sections, long sinceNs) {

    /** {@code bot2 in [A, C] since 12.3 s}. */
    @Override
    public String toString() {
      return robot + " in " + sections + " since " + Time.text(sinceNs, 1);
    }
  }

  /** Whether access was granted and a section is still held; {@code crit().get()}. */
  default boolean od_mutex() {
    return crit().get();
  }

  /** Whether this robot has access to all requested sections that it has not released. */
  GvhVariable<Boolean> crit();

  /** Whether the latest request ended without access. */
  GvhVariable<Boolean> failed();

  /** Why the latest request failed. */
  GvhVariable<MutexFailure> failure();

  /**
   * Releases {@code sections}.
   *
   * @throws IllegalArgumentException if {@code sections} is empty, or not all are held
   */
  void release(Collection<String> sections);

  /** Releases {@code sections}. */
  default void release(String... sections) {
    release(Arrays.asList(sections));
  }

  /** Cancels a waiting request: {@link #failed} becomes true. No effect without one. */
  void withdraw();

  /**
   * Declares, after a restart of the robot's program, that its body is only in {@code sections}.
   * Until then other robots assume that it still holds the sections from before the restart. Call
   * this again with fewer sections as the robot leaves them, and finally with none. The robot may
   * request the declared sections.
   */
  void standsIn(Collection<String> sections);

  /** The sections that this robot has access to. */
  SortedSet<String> held();

  /**
   * Ends this robot's part. A waiting request is withdrawn. Held sections stay held for ever, as
   * after a crash, so release them before. Other robots wait in vain for this robot's consent, so
   * unregister before. An instance cannot be opened again before the robot's program restarts.
   */
  @Override
  void close();
}
