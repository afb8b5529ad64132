package org.starl.primitives.registration;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import org.starl.primitives.Phases;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/**
 * What a trace tells of a registration. Calls of the app, and what the protocol gives up, are actions
 * of the theory; there is one {@code do_register} for each attempt of a call.
 */
public final class RegistrationFact {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "registration";

  /** The paper's pair of list and time stamp. */
  public static final Var<RList> R_LIST = Var.of("rList", RList.SHAPE);

  /** Whether the latest call was given up. */
  public static final Var<Boolean> FAILED = Var.of("failed", Shapes.BOOL);

  /** Whether the robot may end: it has left, and has told the latest view that it has decided. */
  public static final Var<Boolean> UNREGISTERED = Var.of("unregistered", Shapes.BOOL);

  /** The latest view that the robot has learned. */
  public static final Var<View> VIEW = Var.of("view", View.SHAPE);

  /** The actions of the theory that a robot takes; the others are seen by their results. */
  static final SumShape<RegistrationAction> ACTIONS =
      Shapes.oneOf(
          RegistrationAction.class,
          Shapes.of(
              RegistrationAction.do_register.class,
              part("i", PROCESS, RegistrationAction.do_register::i),
              RegistrationAction.do_register::new),
          Shapes.of(
              RegistrationAction.unregister.class,
              part("i", PROCESS, RegistrationAction.unregister::i),
              RegistrationAction.unregister::new),
          Shapes.of(
              RegistrationAction.give_up.class,
              part("i", PROCESS, RegistrationAction.give_up::i),
              RegistrationAction.give_up::new));

  /** A robot proposes to give up an id. */
  static final RecordShape<Confinement> CONFINE = Confinement.SHAPE.named("confine");

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, SynodMessage.SHAPE)
          .facts(PRIMITIVE, ACTIONS)
          .facts(PRIMITIVE, AgreementFact.ACCEPTORS, CONFINE)
          .variables(PRIMITIVE, R_LIST, FAILED, UNREGISTERED, VIEW);

  /** The phases of {@link RegistrationProtocol.Phase}. */
  public static final Phases PHASES =
      Phases.of(PRIMITIVE, SynodMessage.class, ShownPhase::new, (Object[]) Phase.values());

  private RegistrationFact() {}
}
