package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** Messages about tubes. All are idempotent: they may be lost, late, duplicated and reordered. */
sealed interface TubeMessage {

  /** The version of the holding that the message contains or answers. */
  long version();

  /** The sender's tubes; replaces older versions. */
  record Ask(Holding holding) implements TubeMessage {
    @Override
    public long version() {
      return holding.version();
    }
  }

  /** The sender has stored the holding; its wanted tube meets no tube that the sender knows. */
  record Vote(long version) implements TubeMessage {}

  /**
   * The sender has noted the held tubes only: the wanted one meets a tube that {@code who} holds or
   * wants.
   *
   * @param theirs the tubes of {@code who}; {@link Holding#NONE} if its place is not known yet
   */
  record Refuse(long version, RobotId who, Holding theirs) implements TubeMessage {}

  /** The shape of all messages, as in {@code docs/wire-format.md}. */
  Shape<TubeMessage> SHAPE =
      Shapes.oneOf(
          TubeMessage.class,
          Shapes.of(Ask.class, part("holding", Holding.SHAPE, Ask::holding), Ask::new),
          Shapes.of(Vote.class, part("version", Holding.VERSION, Vote::version), Vote::new),
          Shapes.of(
              Refuse.class,
              part("version", Holding.VERSION, Refuse::version),
              part("who", Shapes.ROBOT, Refuse::who),
              part("theirs", Holding.SHAPE, Refuse::theirs),
              Refuse::new));
}
