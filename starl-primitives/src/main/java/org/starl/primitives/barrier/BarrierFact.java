package org.starl.primitives.barrier;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
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

/** What a trace tells of a barrier. An arrival is an action of the theory. */
public final class BarrierFact {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "barrier";

  /** The Synod's own channel. */
  static final String SYNOD = "barrier.synod";

  /** The outcome of the latest arrival. */
  public static final Var<BarrierOutcome> OUTCOME = Var.of("outcome", BarrierOutcome.SHAPE);

  /**
   * The robot takes part from now on.
   *
   * @param i this robot's id
   * @param members of generation 1
   */
  public record Created(ProcessId i, SortedSet<ProcessId> members) {
    public Created {
      members = Collections.unmodifiableSortedSet(new TreeSet<>(members));
    }
  }

  /** Named {@code Barrier}. */
  public static final RecordShape<Created> CREATED =
      Shapes.of(
              Created.class,
              part("i", PROCESS, Created::i),
              part("members", Shapes.set(PROCESS, 0xFFFF), Created::members),
              Created::new)
          .named("Barrier");

  /** An id arrives in a generation. */
  public static final RecordShape<BarrierAction.arrive> ARRIVE =
      Shapes.of(
          BarrierAction.arrive.class,
          part("i", PROCESS, BarrierAction.arrive::i),
          part("g", LONG, BarrierAction.arrive::g),
          BarrierAction.arrive::new);

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, BarrierMessage.SHAPE)
          .messages(SYNOD, SynodMessage.SHAPE)
          .facts(PRIMITIVE, CREATED, ARRIVE)
          .variables(PRIMITIVE, OUTCOME);

  private static final String IDLE = "IDLE";
  private static final String WAITING = "WAITING";
  private static final String PASSED = "PASSED";
  private static final String FAILED = "FAILED";

  /** The phases of the latest wait: none yet, going on, passed, and failed in any way. */
  public static final Phases PHASES =
      Phases.of(
              PRIMITIVE,
              BarrierMessage.class,
              () -> BarrierFact::phase,
              IDLE,
              WAITING,
              PASSED,
              FAILED)
          .with(SYNOD, SynodMessage.class);

  private BarrierFact() {}

  private static String phase(String before, TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof BarrierAction.arrive) {
      return WAITING;
    }
    BarrierOutcome outcome = event instanceof Variable variable ? variable.of(OUTCOME) : null;
    if (outcome == null || !outcome.isTold()) {
      return before;
    }
    return outcome instanceof BarrierOutcome.Passed ? PASSED : FAILED;
  }
}
