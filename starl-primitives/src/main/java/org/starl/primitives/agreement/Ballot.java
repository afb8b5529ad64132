package org.starl.primitives.agreement;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The rank of one attempt of one proposer. It is unique: a proposer uses no round twice, and no two
 * proposers use the same id. So a restarted proposer needs no stored state.
 *
 * @param round above 0
 */
public record Ballot(long round, ProcessId proposer) implements Comparable<Ballot> {

  /** Its shape. */
  public static final Shape<Ballot> SHAPE =
      Shapes.of(
          Ballot.class,
          part("round", LONG, Ballot::round),
          part("proposer", PROCESS, Ballot::proposer),
          Ballot::new);

  public Ballot {
    if (round <= 0) {
      throw new IllegalArgumentException("round " + round + ": expected above 0");
    }
  }

  @Override
  public int compareTo(Ballot other) {
    int byRound = Long.compare(round, other.round);
    return byRound != 0 ? byRound : proposer.compareTo(other.proposer);
  }

  /** {@code 3/bot1}: round, then proposer. */
  @Override
  public String toString() {
    return round + "/" + proposer;
  }
}
