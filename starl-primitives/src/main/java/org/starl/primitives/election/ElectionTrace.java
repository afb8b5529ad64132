package org.starl.primitives.election;

/**
 * The names of elections in a trace. Ids are as {@link org.starl.id.ProcessId#parse} reads them.
 */
public final class ElectionTrace {

  public static final String PRIMITIVE = "election";

  /** The Synod's own channel. */
  static final String SYNOD = "election.synod";

  /** Action with the number of participants, and this robot's id. */
  static final String ELECTION = "Election";

  /** Action: the app's call, with the id that is a candidate from now on. */
  static final String DO_ELECTION = "do_election";

  /** Action with a term and the id that may be elected in it from now on. */
  static final String CANDIDATE = "candidate";

  /** Variable: {@code null}, {@code fail}, or term and id, as in {@code 3:bot1#4294967297}. */
  public static final String LEADER = "Leader";

  /** Variable: whether {@code Leader} is {@code fail}. */
  static final String FAILED = "failed";

  private ElectionTrace() {}

  /** Whether {@code source} is an election, as in {@code election/convoy}. */
  static boolean isElection(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
