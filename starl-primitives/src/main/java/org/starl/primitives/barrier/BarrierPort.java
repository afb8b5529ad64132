package org.starl.primitives.barrier;

import org.starl.id.RobotId;

/** The own messages of a {@link BarrierProtocol}, sent best effort. */
interface BarrierPort {

  void send(RobotId to, BarrierMessage message);
}
