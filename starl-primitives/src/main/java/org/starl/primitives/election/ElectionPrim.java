package org.starl.primitives.election;

import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/** The election interface for apps (paper, section 4.4). Strand only. */
public interface ElectionPrim extends StarLPrimitive {

  /**
   * Makes this robot a candidate: it may be elected, and takes part whenever a leader is needed. A leader
   * that is not suspected stays; an election in progress goes on; otherwise one begins. Then {@link
   * #Leader} is null until it is a name, or {@link Leader#FAIL} at the deadline.
   *
   * @throws IllegalStateException if this robot is not among the participants
   */
  void do_election();

  /**
   * The leader, as far as this robot knows. A replaced leader and its followers may not know of the new
   * one yet: a leader's commands should carry its term, and robots should ignore lower terms. An action
   * that only one robot may do at a time needs a mutex, not a leader.
   */
  GvhVariable<Leader> Leader();

  /** Whether {@link #Leader} is {@link Leader#FAIL}. */
  GvhVariable<Boolean> failed();
}
