package org.starl.primitives.registration;

import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;

/** The effects of a {@link RegistrationProtocol}: messages, ids, and what the trace shows. */
interface RegistrationPort {

  /** Sends until acknowledged or given up, and then runs {@code settled} as an input. */
  void sendReliably(RobotId to, SynodMessage message, Runnable settled);

  /** An id that this robot has never used and will never use again. */
  ProcessId freshProcess();

  /** Traces an action of {@link RegistrationTrace}. */
  void trace(String action, Object... args);
}
