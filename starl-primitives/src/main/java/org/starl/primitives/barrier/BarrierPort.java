package org.starl.primitives.barrier;

import org.starl.RobotId;

/** Where a {@link BarrierProtocol}'s effects go. All messages are best effort. */
interface BarrierPort {

  void send(RobotId to, BarrierMessage message);
}
