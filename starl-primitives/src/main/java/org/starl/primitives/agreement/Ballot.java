package org.starl.primitives.agreement;

import org.starl.id.ProcessId;

/**
 * The rank of one attempt of one proposer. It is unique: a proposer uses no round twice, and no two
 * proposers use the same id. So a restarted proposer needs no stored state.
 *
 * @param round above 0
 */
public record Ballot(long round, ProcessId proposer) implements Comparable<Ballot> {

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

  /** {@code 3/bot1#4294967297}: round, then proposer. */
  @Override
  public String toString() {
    return round + "/" + proposer;
  }

  /**
   * Parses the text of {@link #toString}.
   *
   * @throws IllegalArgumentException if {@code text} has another form
   */
  static Ballot parse(String text) {
    int slash = text.indexOf('/');
    if (slash < 0) {
      throw new IllegalArgumentException("ballot '" + text + "': expected round/robot#incarnation");
    }
    return new Ballot(
        Long.parseLong(text.substring(0, slash)), ProcessId.parse(text.substring(slash + 1)));
  }
}
