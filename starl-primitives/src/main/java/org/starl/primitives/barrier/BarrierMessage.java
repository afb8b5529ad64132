package org.starl.primitives.barrier;

import static org.starl.shape.Shapes.BOOL;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The barrier's own messages. All are idempotent. */
sealed interface BarrierMessage {

  /** Their shape. The bytes are in {@code docs/wire-format.md}. */
  Shape<BarrierMessage> SHAPE = shape();

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

  private static Shape<BarrierMessage> shape() {
    Shape<Long> generation = Shapes.atLeast(1, "generation");
    return Shapes.oneOf(
        BarrierMessage.class,
        Shapes.of(
            Arrival.class,
            part("from", PROCESS, Arrival::from),
            part("generation", generation, Arrival::generation),
            Arrival::new),
        Shapes.of(
            Here.class,
            part("from", PROCESS, Here::from),
            part("generation", generation, Here::generation),
            part("hasArrived", BOOL, Here::hasArrived),
            part("noted", generation, Here::noted),
            Here::new));
  }
}
