package org.starl.primitives.agreement;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The Synod's messages. All are idempotent: each may be lost, late, doubled and reordered.
 *
 * <p>A sequence of decrees is numbered 1, 2, 3, ...; each number is an instance of consensus of its
 * own.
 */
public sealed interface SynodMessage {

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
  record Decided(long number, Value value) implements SynodMessage {}

  /** Asks for the latest decree, if it is above {@code number}; 0 asks for any. */
  record Query(long number) implements SynodMessage {}

  /** One vote of an acceptor. */
  record Vote(Ballot ballot, Value value) {}
}
