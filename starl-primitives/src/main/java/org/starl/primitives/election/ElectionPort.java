package org.starl.primitives.election;

import org.starl.RobotId;
import org.starl.primitives.agreement.SynodMessage;

/** Where an {@link ElectionProtocol}'s effects go. All messages are best effort. */
interface ElectionPort {

  void send(RobotId to, ElectionMessage message);

  /** To every robot but this one. */
  void broadcast(ElectionMessage message);

  /** To this robot itself as well. */
  void send(RobotId to, SynodMessage message);

  /** As {@link org.starl.primitives.agreement.SynodPort#persist}. */
  void persist(long version, byte[] record);

  /** This robot may be elected in {@code term} from now on. */
  void candidate(long term);
}
