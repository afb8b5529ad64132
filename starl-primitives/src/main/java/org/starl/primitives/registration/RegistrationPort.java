package org.starl.primitives.registration;

import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

/** Where a {@link RegistrationProtocol}'s effects go. */
interface RegistrationPort {

  /** Sends until acknowledged or in vain for long, and then runs {@code settled} as an input. */
  void sendReliably(RobotId to, SynodMessage message, Runnable settled);

  /** An id that this robot has never used and will never use again. */
  ProcessId freshProcess();

  /** The deployment gives this first view. */
  void isGiven(View first);

  /** This robot asks for {@code id} to be in. */
  void asksFor(ProcessId id);

  /** This robot asks for {@code id} to be out, which will never request anything again. */
  void unregisters(ProcessId id);

  /** This robot works for {@code confinement}. */
  void confines(Confinement confinement);

  /** {@code id} was asked in, but requests nothing and never will again: it may be taken out. */
  void givesUp(ProcessId id);
}
