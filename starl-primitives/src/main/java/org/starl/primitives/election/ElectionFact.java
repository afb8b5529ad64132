package org.starl.primitives.election;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.id.ProcessId;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/**
 * What a trace tells of an election. The app's call, and a robot's candidacy in a term, are actions of
 * the theory.
 */
public final class ElectionFact {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "election";

  /** The Synod's own channel. */
  static final String SYNOD = "election.synod";

  /** The paper's {@code Leader}. */
  public static final Var<Leader> LEADER = Var.of("Leader", Leader.SHAPE);

  /** Whether {@code Leader} is fail. */
  public static final Var<Boolean> FAILED = Var.of("failed", Shapes.BOOL);

  /**
   * The robot takes part from now on.
   *
   * @param size the number of participants
   * @param i this robot's id
   */
  public record Created(int size, ProcessId i) {}

  /** Named {@code Election}. */
  public static final RecordShape<Created> CREATED =
      Shapes.of(
              Created.class,
              part("size", INT, Created::size),
              part("i", PROCESS, Created::i),
              Created::new)
          .named("Election");

  /** The app's call: the id is a candidate from now on. */
  public static final RecordShape<ElectionAction.do_election> DO_ELECTION =
      Shapes.of(
          ElectionAction.do_election.class,
          part("i", PROCESS, ElectionAction.do_election::i),
          ElectionAction.do_election::new);

  /** The id may be elected in the term from now on. */
  public static final RecordShape<ElectionAction.candidate> CANDIDATE =
      Shapes.of(
          ElectionAction.candidate.class,
          part("i", PROCESS, ElectionAction.candidate::i),
          part("n", LONG, ElectionAction.candidate::n),
          ElectionAction.candidate::new);

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, ElectionMessage.SHAPE)
          .messages(SYNOD, SynodMessage.SHAPE)
          .facts(PRIMITIVE, CREATED, DO_ELECTION, CANDIDATE)
          .variables(PRIMITIVE, LEADER, FAILED);

  private static final String NO_CANDIDATE = "NO_CANDIDATE";
  private static final String WAITING = "WAITING";
  private static final String KNOWS_LEADER = "KNOWS_LEADER";
  private static final String HAS_FAILED = "FAILED";

  /** The phases: it has not called {@code do_election}, shows null, a leader, or fail. */
  public static final Phases PHASES =
      Phases.of(
              PRIMITIVE,
              ElectionMessage.class,
              () -> ElectionFact::phase,
              NO_CANDIDATE,
              WAITING,
              KNOWS_LEADER,
              HAS_FAILED)
          .with(SYNOD, SynodMessage.class);

  private ElectionFact() {}

  private static String phase(String before, TraceEvent event) {
    boolean isCandidate = !before.equals(NO_CANDIDATE);
    if (event instanceof Action action && action.fact() instanceof ElectionAction.do_election) {
      return isCandidate ? before : WAITING;
    }
    Leader leader = event instanceof Variable variable ? variable.of(LEADER) : null;
    if (leader == null) {
      return before;
    }
    return switch (leader) {
      case Leader.None none -> isCandidate ? WAITING : before;
      case Leader.Fail fail -> HAS_FAILED;
      case Leader.Name name -> KNOWS_LEADER;
    };
  }
}
