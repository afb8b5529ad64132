package org.starl.primitives.barrier;

import org.starl.id.RobotId;

/** Where a {@link BarrierProtocol}'s effects go. All messages are best effort. */
interface BarrierPort {

  void send(RobotId to, BarrierMessage message);
}
