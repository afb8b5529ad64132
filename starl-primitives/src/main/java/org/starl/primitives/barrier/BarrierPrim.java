package org.starl.primitives.barrier;

import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/** The barrier interface for apps. Reusable: generations 1, 2, 3, ... Strand only. */
public interface BarrierPrim extends StarLPrimitive {

  /**
   * Arrives in the present generation and waits: {@link #outcome} is null until it is known. Use
   * {@code await(() -> barrier.outcome().get().isTold())}.
   *
   * @throws IllegalStateException if this robot is waiting
   */
  void arrive();

  /** The outcome of the latest {@link #arrive}. */
  GvhVariable<BarrierOutcome> outcome();

  /** The generation in which this robot waits, or will arrive next; from 1. */
  long generation();
}
