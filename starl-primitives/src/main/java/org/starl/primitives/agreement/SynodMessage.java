package org.starl.primitives.agreement;

import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;

/**
 * The Synod's messages. All are idempotent: each may be lost, late, doubled and reordered.
 *
 * <p>A sequence of decrees is numbered 1, 2, 3, ...; each number is an instance of consensus of its
 * own.
 */
public sealed interface SynodMessage {

  /** The shape of messages with any values and wishes: for readers of traces. */
  Shape<SynodMessage> SHAPE = shape(Value.SHAPE, Value.SHAPE);

  /** The number of the decree. */
  long number();

  /**
   * A proposer asks for the right to propose.
   *
   * @param wish what the proposer wants in this decree; other proposers of the same number may fulfil
   *     it. Empty if values cannot be combined
   */
  record Prepare(long number, Ballot ballot, Value wish) implements SynodMessage {}

  /**
   * An acceptor will accept no lower ballot.
   *
   * @param vote its vote in the highest ballot so far, or null
   * @param wishes the wishes it has heard for this number; none beside a vote, which binds the proposer
   *     anyway
   */
  record Promise(long number, Ballot ballot, @Nullable Vote vote, List<Value> wishes)
      implements SynodMessage {
    public Promise {
      wishes = List.copyOf(wishes);
    }
  }

  /** An acceptor has promised a higher ballot; {@code ballot} cannot have its vote. */
  record Nack(long number, Ballot ballot, Ballot promised) implements SynodMessage {}

  /** A proposer asks for a vote. */
  record Accept(long number, Ballot ballot, Value value) implements SynodMessage {}

  /** An acceptor has voted. */
  record Accepted(long number, Ballot ballot) implements SynodMessage {}

  /** The decided value of this number. */
  record Decided(long number, Value value) implements SynodMessage {
    static RecordShape<Decided> shape(Shape<Value> values) {
      return Shapes.of(
          Decided.class,
          part("number", numbers(1), Decided::number),
          part("value", values, Decided::value),
          Decided::new);
    }
  }

  /** Asks for the latest decree, if it is above {@code number}; 0 asks for any. */
  record Query(long number) implements SynodMessage {}

  /** One vote of an acceptor. */
  record Vote(Ballot ballot, Value value) {
    static RecordShape<Vote> shape(Shape<Value> values) {
      return Shapes.of(
          Vote.class,
          part("ballot", Ballot.SHAPE, Vote::ballot),
          part("value", values, Vote::value),
          Vote::new);
    }
  }

  private static Shape<Long> numbers(long least) {
    return Shapes.atLeast(least, "decree number");
  }

  /**
   * The shape of the messages of one channel.
   *
   * @param values those that may be decided
   * @param wishes those that proposers may have
   */
  static SumShape<SynodMessage> shape(Shape<Value> values, Shape<Value> wishes) {
    Shape<Long> number = numbers(1);
    return Shapes.oneOf(
        SynodMessage.class,
        Shapes.of(
            Prepare.class,
            part("number", number, Prepare::number),
            part("ballot", Ballot.SHAPE, Prepare::ballot),
            part("wish", wishes, Prepare::wish),
            Prepare::new),
        Shapes.of(
            Promise.class,
            part("number", number, Promise::number),
            part("ballot", Ballot.SHAPE, Promise::ballot),
            part("vote", Shapes.optional(Vote.shape(values)), m -> Optional.ofNullable(m.vote())),
            part("wishes", Shapes.list(wishes, 0xFF), Promise::wishes),
            (decree, ballot, vote, heard) -> new Promise(decree, ballot, vote.orElse(null), heard)),
        Shapes.of(
            Nack.class,
            part("number", number, Nack::number),
            part("ballot", Ballot.SHAPE, Nack::ballot),
            part("promised", Ballot.SHAPE, Nack::promised),
            Nack::new),
        Shapes.of(
            Accept.class,
            part("number", number, Accept::number),
            part("ballot", Ballot.SHAPE, Accept::ballot),
            part("value", values, Accept::value),
            Accept::new),
        Shapes.of(
            Accepted.class,
            part("number", number, Accepted::number),
            part("ballot", Ballot.SHAPE, Accepted::ballot),
            Accepted::new),
        Decided.shape(values),
        Shapes.of(Query.class, part("number", numbers(0), Query::number), Query::new));
  }
}
