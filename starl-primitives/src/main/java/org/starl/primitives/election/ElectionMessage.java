package org.starl.primitives.election;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The election's own messages. All are idempotent. */
sealed interface ElectionMessage {

  /** Their shape. The bytes are in {@code docs/wire-format.md}. */
  Shape<ElectionMessage> SHAPE = shape();

  /** An id of the sender. */
  ProcessId from();

  /** The term, from 1. */
  long term();

  /**
   * {@code from} may be elected in {@code term}.
   *
   * @param draw its random number in this term
   */
  record Candidacy(ProcessId from, long term, long draw) implements ElectionMessage {}

  /** {@code leader} is decided for {@code term}. */
  record Elected(ProcessId from, long term, ProcessId leader) implements ElectionMessage {}

  private static Shape<ElectionMessage> shape() {
    Shape<Long> term = Shapes.atLeast(1, "election term");
    return Shapes.oneOf(
        ElectionMessage.class,
        Shapes.of(
            Candidacy.class,
            part("from", PROCESS, Candidacy::from),
            part("term", term, Candidacy::term),
            part("draw", LONG, Candidacy::draw),
            Candidacy::new),
        Shapes.of(
            Elected.class,
            part("from", PROCESS, Elected::from),
            part("term", term, Elected::term),
            part("leader", PROCESS, Elected::leader),
            Elected::new));
  }
}
