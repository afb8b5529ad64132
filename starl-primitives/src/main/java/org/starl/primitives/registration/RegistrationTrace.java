package org.starl.primitives.registration;

import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.registration.RegistrationProtocol.Phase;

/**
 * The names of registrations in a trace. Views are as {@link
 * org.starl.primitives.membership.View#parse} reads them, ids as {@link org.starl.id.ProcessId#parse}.
 */
public final class RegistrationTrace {

  public static final String PRIMITIVE = "registration";

  /** Action with the robots that vote, each an argument. */
  static final String ACCEPTORS = "acceptors";

  /** Action with the id that asks to be admitted; one for each attempt of a call. */
  static final String DO_REGISTER = "do_register";

  /** Action with the id that asks to be removed. */
  static final String UNREGISTER = "unregister";

  /**
   * Action with the id to give up, the sections that it may hold, and the fencers, as {@link org.starl.primitives.membership.Confinement#parse} reads them.
   */
  static final String CONFINE = "confine";

  /** Action with an id that asked to be admitted, and will request nothing. */
  static final String GIVE_UP = "give_up";

  /** Variable: {@code null}, or time stamp and list, as in {@code 3:[bot0, bot2]}. */
  static final String R_LIST = "rList";

  /** Variable: whether the latest call was given up. */
  static final String FAILED = "failed";

  /** Variable: the latest view that the robot has learned. */
  public static final String VIEW = "view";

  /** The phases of {@link RegistrationProtocol.Phase}. */
  public static final Phases PHASES =
      Phases.of(PRIMITIVE, SynodMessage.class, ShownPhase::new, (Object[]) Phase.values());

  private RegistrationTrace() {}

  /** Whether {@code source} is a registration, as in {@code registration/crossing}. */
  static boolean isRegistration(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
