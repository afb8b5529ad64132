package org.starl.primitives.barrier;

import org.starl.id.ProcessId;

/** The barrier's own messages. All are idempotent. */
sealed interface BarrierMessage {

  /** The member of the sender. */
  ProcessId from();

  /** {@code from} has arrived in {@code generation}; repeated until that generation ends. */
  record Arrival(ProcessId from, long generation) implements BarrierMessage {}

  /**
   * Answers an arrival: {@code from} is alive.
   *
   * @param generation the present one of {@code from}
   * @param hasArrived whether it has arrived in it
   * @param noted the generation of the arrival that this acknowledges
   */
  record Here(ProcessId from, long generation, boolean hasArrived, long noted)
      implements BarrierMessage {}
}
