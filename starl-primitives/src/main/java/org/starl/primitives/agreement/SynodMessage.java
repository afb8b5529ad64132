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

  /** The decree that this is about. */
  long number();

  /**
   * A proposer asks for the right to propose.
   *
   * @param wish what the proposer would have in this decree; whoever proposes for the same number
   *     may fulfil it. Empty where nothing can be combined
   */
  record Prepare(long number, Ballot ballot, Value wish) implements SynodMessage {}

  /**
   * An acceptor will accept no lower ballot.
   *
   * @param vote what it has accepted in the highest ballot so far, or null
   * @param wishes wishes that it has heard for this number; none beside a vote, which binds the
   *     proposer anyway
   */
  record Promise(long number, Ballot ballot, @Nullable Vote vote, List<Value> wishes)
      implements SynodMessage {
    public Promise {
      wishes = List.copyOf(wishes);
    }
  }

  /** An acceptor has promised a higher ballot; {@code ballot} is in vain with it. */
  record Nack(long number, Ballot ballot, Ballot promised) implements SynodMessage {}

  /** A proposer asks for a vote. */
  record Accept(long number, Ballot ballot, Value value) implements SynodMessage {}

  /** An acceptor has voted. */
  record Accepted(long number, Ballot ballot) implements SynodMessage {}

  /** The value of this number, once and for all. */
  record Decided(long number, Value value) implements SynodMessage {}

  /** Asks for the latest decree, if it is above {@code number}; 0 asks for any. */
  record Query(long number) implements SynodMessage {}

  /** One vote of an acceptor. */
  record Vote(Ballot ballot, Value value) {}
}
