package org.starl.primitives.barrier;

import org.starl.id.ProcessId;

/** The barrier's own messages, beside the Synod's. All are idempotent. */
sealed interface BarrierMessage {

  /** Who says so: the sender's member. */
  ProcessId from();

  /** {@code from} has arrived in {@code generation}; it is repeated until that is over. */
  record Arrival(ProcessId from, long generation) implements BarrierMessage {}

  /**
   * Answers an arrival: {@code from} is alive.
   *
   * @param generation the one that {@code from} is in
   * @param hasArrived whether it has arrived in it
   * @param noted the generation of the arrival that this answers
   */
  record Here(ProcessId from, long generation, boolean hasArrived, long noted)
      implements BarrierMessage {}
}
