package org.starl.primitives.election;

import org.starl.id.RobotId;

/** The effects of an {@link ElectionProtocol}. Messages are sent best effort. */
interface ElectionPort {

  void send(RobotId to, ElectionMessage message);

  /** To every robot but this one. */
  void broadcast(ElectionMessage message);

  /** This robot may be elected in {@code term} from now on. */
  void candidate(long term);
}
