package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.U16;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The messages of ledgers, beside those of the Synod. All are idempotent. */
public sealed interface LedgerMessage {

  /** Their shape. */
  Shape<LedgerMessage> SHAPE =
      Shapes.oneOf(
          LedgerMessage.class,
          Shapes.of(
              Here.class,
              part("from", PROCESS, Here::from),
              part("number", Shapes.atLeast(0, "decree number"), Here::number),
              part("asks", Shapes.BOOL, Here::asks),
              Here::new),
          Shapes.of(
              Part.class,
              part("from", PROCESS, Part::from),
              part("number", Shapes.atLeast(1, "decree number"), Part::number),
              part("index", U16, Part::index),
              part("count", U16, Part::count),
              part("bytes", Value.SHAPE, Part::bytes),
              Part::new));

  /** The sender. */
  ProcessId from();

  /**
   * The sender lives.
   *
   * @param number of the latest decree that it knows; 0 for none
   * @param asks whether it asks for later ones
   */
  record Here(ProcessId from, long number, boolean asks) implements LedgerMessage {}

  /**
   * A part of the state after a decree: for a robot that lacks decrees which the sender no longer has.
   *
   * @param index from 0
   * @param count of all parts
   */
  record Part(ProcessId from, long number, int index, int count, Value bytes)
      implements LedgerMessage {
    public Part {
      if (index >= count) {
        throw new IllegalArgumentException("part " + index + " of " + count);
      }
    }
  }
}
