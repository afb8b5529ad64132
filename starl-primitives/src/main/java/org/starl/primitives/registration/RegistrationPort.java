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

  /** This robot asks to admit {@code id}. */
  void register(ProcessId id);

  /** This robot asks to remove {@code id}, which will never request anything again. */
  void unregister(ProcessId id);

  /** This robot proposes {@code confinement}. */
  void confine(Confinement confinement);

  /** {@code id}, which had asked to be admitted, will never request anything: it may be removed. */
  void giveUp(ProcessId id);
}
