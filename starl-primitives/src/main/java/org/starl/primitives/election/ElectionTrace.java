package org.starl.primitives.election;

import java.util.List;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SynodMessage;

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

  private static final String NO_CANDIDATE = "NO_CANDIDATE";
  private static final String WAITING = "WAITING";
  private static final String KNOWS_LEADER = "KNOWS_LEADER";
  private static final String HAS_FAILED = "FAILED";

  /** The phases: it has not called {@code do_election}, shows null, a leader, or fail. */
  public static final Phases PHASES =
      Phases.of(
              PRIMITIVE,
              ElectionMessage.class,
              () -> ElectionTrace::phase,
              NO_CANDIDATE,
              WAITING,
              KNOWS_LEADER,
              HAS_FAILED)
          .with(SYNOD, SynodMessage.class);

  private ElectionTrace() {}

  private static String phase(String before, String name, List<String> texts) {
    return switch (name) {
      case DO_ELECTION -> before.equals(NO_CANDIDATE) ? WAITING : before;
      case LEADER ->
          switch (texts.get(0)) {
            case "null" -> before.equals(NO_CANDIDATE) ? before : WAITING;
            case "fail" -> HAS_FAILED;
            default -> KNOWS_LEADER;
          };
      default -> before;
    };
  }

  /** Whether {@code source} is an election, as in {@code election/convoy}. */
  static boolean isElection(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
