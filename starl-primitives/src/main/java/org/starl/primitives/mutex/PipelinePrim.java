package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.List;

/**
 * Mutual exclusion on sequences: access to sections one after another, in the order in which the robot
 * passes them. Each section is granted when all that come before it there have left it, so robots follow
 * each other closely. Strand only.
 *
 * <pre>{@code
 * mux.doSequence(List.of("A", "C", "D"));
 * // drive on while mux.held() has the next section, and stop before it while it has not;
 * // release each section when the body has left it
 * }</pre>
 *
 * <p>All sections have one order of robots, that of their requests. So robots that hold some sections
 * and wait for others never wait in a circle. Sets ({@link #do_mutex}) and sequences of one instance
 * exclude each other.
 */
public interface PipelinePrim extends MutexPrim {

  /**
   * Requests access to {@code sections}, one by one in this order. {@link #held} grows with each grant,
   * and {@link #crit} is true while something is held. {@link #failed} becomes true if the rest will not
   * be granted; what is held stays held. A request fails before it holds a section, except that a robot
   * that others have given up as crashed ({@link MutexFailure#mustRegister}) may hold some: it registers
   * again, and requests the rest of its sequence, what it holds included. Unlike {@link #do_mutex}, this
   * is allowed then.
   *
   * @param sections 1 to 32 different names, as for {@link #do_mutex}
   * @throws IllegalStateException while an earlier request waits, or holds sections otherwise
   * @throws IllegalArgumentException if {@code sections} is no such list, or lacks a section that is held
   */
  void doSequence(List<String> sections);

  /**
   * Declares, after a restart of the robot's program in the middle of its sequence, that its body is only
   * in {@code stands}, and that it will request {@code sections}. Then it comes before all robots that have
   * to wait for its body anyway. What its earlier program held of {@code sections} stays its own until it
   * has released it, or has consented to the request of another robot for it; other sections are free at
   * once. Call it before {@code do_register}; and again, while it holds nothing and waits for nothing, if
   * the body is in fewer sections than it seemed.
   *
   * <p>No other robot gets a section of {@code stands}. So request only those ahead, and {@link #release}
   * each of {@code stands} when the body has left it: a robot that asks for the section in which it stands
   * may wait for one that waits for its body.
   *
   * @param stands among {@code sections}, and held by the earlier program
   * @param sections the rest of the sequence
   */
  void resume(Collection<String> stands, List<String> sections);

  /**
   * How many other robots are known to hold or to wait for all of {@code sections}: a robot that asks for
   * one of these now comes after them there. A hint for a good time to ask; it may be out of date.
   */
  int contenders(String... sections);
}
