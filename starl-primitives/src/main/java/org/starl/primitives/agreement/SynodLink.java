package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/** The effects of a {@link Synod} on its robot: network, and stable storage for its acceptor. */
public interface SynodLink {

  /** The last {@link #persist}ed record, also from before a restart; null if there is none. */
  byte @Nullable [] record();

  /** Sends, best effort; to this robot itself as well. */
  void send(RobotId to, SynodMessage message);

  /**
   * Replaces the acceptor's record. Later, once it would survive a crash, the owner calls {@link
   * Synod#flushed} with {@code version}. Writes are flushed in order.
   */
  void persist(long version, byte[] record);
}
