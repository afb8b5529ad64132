package org.starl.primitives.barrier;

import org.starl.RobotId;
import org.starl.primitives.agreement.SynodMessage;

/** Where a {@link BarrierProtocol}'s effects go. All messages are best effort. */
interface BarrierPort {

  void send(RobotId to, BarrierMessage message);

  /** To this robot itself as well. */
  void send(RobotId to, SynodMessage message);

  /** As {@link org.starl.primitives.agreement.SynodPort#persist}. */
  void persist(long version, byte[] record);
}
