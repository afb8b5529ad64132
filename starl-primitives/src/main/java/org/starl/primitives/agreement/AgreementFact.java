package org.starl.primitives.agreement;

import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.Optional;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a {@link SetAgreement}. A proposal is an action of the theory. */
public final class AgreementFact {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "agreement";

  private static final Shape<Optional<Value>> BYTES = Shapes.optional(Value.SHAPE);

  /**
   * The decision: its bytes, or none. A reader of traces need not know the shape of the values: it
   * reads a decision on a text, the bytes in hexadecimal digits.
   */
  public static final Var<Decision<?>> DECIDED =
      Var.of("decided", BYTES.as(BYTES.describe(), AgreementFact::bytes, AgreementFact::decision));

  /** Whether the latest proposal was given up at its deadline. */
  public static final Var<Boolean> FAILED = Var.of("failed", Shapes.BOOL);

  /** The robots that vote: from now on this robot serves, if it is one of them. */
  public record Acceptors(List<RobotId> robots) {
    public Acceptors {
      robots = List.copyOf(robots);
    }
  }

  /** Named {@code acceptors}. */
  public static final RecordShape<Acceptors> ACCEPTORS =
      Shapes.of(
              Acceptors.class,
              part("robots", Shapes.list(ROBOT, 0xFFFF), Acceptors::robots),
              Acceptors::new)
          .named("acceptors");

  /** A proposal: the robot, and the value's bytes in hexadecimal digits. */
  public static final RecordShape<AgreementAction.propose> PROPOSE =
      Shapes.of(
          AgreementAction.propose.class,
          part("i", ROBOT, AgreementAction.propose::i),
          // Longer than other texts.
          part("v", Shapes.text("text", v -> v, v -> v), AgreementAction.propose::v),
          AgreementAction.propose::new);

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, SynodMessage.SHAPE)
          .facts(PRIMITIVE, ACCEPTORS, PROPOSE)
          .variables(PRIMITIVE, DECIDED, FAILED);

  private static final String IDLE = "IDLE";
  private static final String PROPOSING = "PROPOSING";
  private static final String HAS_DECIDED = "DECIDED";
  private static final String GAVE_UP = "FAILED";

  /** The phases: it has not proposed, proposes, knows the decision, or has given up. */
  public static final Phases PHASES =
      Phases.of(
          PRIMITIVE,
          SynodMessage.class,
          () -> AgreementFact::phase,
          IDLE,
          PROPOSING,
          HAS_DECIDED,
          GAVE_UP);

  private AgreementFact() {}

  private static Optional<Value> bytes(Decision<?> decision) {
    return decision instanceof Decision.Decided<?> decided
        ? Optional.of(decided.bytes())
        : Optional.empty();
  }

  private static Decision<?> decision(Optional<Value> bytes) {
    return bytes.isPresent()
        ? new Decision.Decided<>(bytes.get().toString(), bytes.get())
        : new Decision.NoneYet<String>();
  }

  private static String phase(String before, TraceEvent event) {
    boolean hasDecided = before.equals(HAS_DECIDED);
    return switch (event) {
      case Action action when action.fact() instanceof AgreementAction.propose ->
          hasDecided ? before : PROPOSING;
      case Variable variable when variable.of(DECIDED) instanceof Decision.Decided<?> ->
          HAS_DECIDED;
      case Variable variable when !hasDecided && Boolean.TRUE.equals(variable.of(FAILED)) ->
          GAVE_UP;
      default -> before;
    };
  }

  /** {@link #DECIDED}, of decisions on values of one type: all are written alike. */
  @SuppressWarnings("unchecked") // its shape reads the bytes of a decision, never its value
  static <T> Var<Decision<T>> decided() {
    return (Var<Decision<T>>) (Var<?>) DECIDED;
  }
}
