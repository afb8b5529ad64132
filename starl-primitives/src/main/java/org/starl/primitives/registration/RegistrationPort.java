package org.starl.primitives.registration;

import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Confinement;

/** The effects of a {@link RegistrationProtocol}: messages, ids, and what the trace shows. */
interface RegistrationPort {

  /** Sends until acknowledged or given up, and then runs {@code settled} as an input. */
  void sendReliably(RobotId to, SynodMessage message, Runnable settled);

  /** An id that this robot has never used and will never use again. */
  ProcessId freshProcess();

  /** Traces an action. */
  void acted(RegistrationAction action);

  /** Traces that this robot proposes {@code confinement}. */
  void confines(Confinement confinement);
}
