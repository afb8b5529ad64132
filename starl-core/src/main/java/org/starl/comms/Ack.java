package org.starl.comms;

import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;

/**
 * An acknowledgement of a reliable message, as the trace shows it.
 *
 * @param order the message's number among its sender's reliable messages to this robot
 */
public record Ack(long order) {

  /** The channel of acknowledgements in the trace. It has no instance, so no channel has its name. */
  public static final Instance CHANNEL = Instance.of("ack");

  /** Its shape. */
  public static final RecordShape<Ack> SHAPE =
      Shapes.of(Ack.class, Shapes.part("order", Shapes.LONG, Ack::order), Ack::new);

  @Override
  public String toString() {
    return "ack " + order;
  }
}
