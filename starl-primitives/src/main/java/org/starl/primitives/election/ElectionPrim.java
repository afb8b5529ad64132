package org.starl.primitives.election;

import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/** Election as an app sees it (paper, section 4.4). Strand only. */
public interface ElectionPrim extends StarLPrimitive {

  /**
   * Takes part from now on: this robot may be elected, and joins in whenever a leader is needed. If
   * there is a leader who is not suspected, it is kept; if an election is in progress, it goes on;
   * else one begins, and {@link #Leader} is null until it is a name, or {@link Leader#FAIL} at the
   * deadline.
   *
   * @throws IllegalStateException if this robot is none of the participants
   */
  void do_election();

  /**
   * The leader as far as this robot knows. A leader that has been replaced may not know it yet, nor
   * may those who follow it: what it commands should carry its term, and lower terms be ignored. What
   * one robot alone may do belongs under a mutex, not under this.
   */
  GvhVariable<Leader> Leader();

  /** Whether {@link #Leader} is {@link Leader#FAIL}. */
  GvhVariable<Boolean> failed();
}
