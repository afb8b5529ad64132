package org.starl.primitives.barrier;

import org.starl.gvh.GvhVariable;
import org.starl.primitives.StarLPrimitive;

/** A barrier as an app sees it; reusable, generation after generation. Strand only. */
public interface BarrierPrim extends StarLPrimitive {

  /**
   * Arrives in the present generation, and waits: {@link #outcome} is nothing until it is told. For
   * {@code await(() -> barrier.outcome().get().isTold())}.
   *
   * @throws IllegalStateException if this robot waits already
   */
  void arrive();

  /** What the latest {@link #arrive} came to. */
  GvhVariable<BarrierOutcome> outcome();

  /** The generation in which this robot waits, or will arrive next; from 1. */
  long generation();
}
