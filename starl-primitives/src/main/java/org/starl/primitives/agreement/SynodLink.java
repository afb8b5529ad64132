package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/** What a {@link Synod} has of its robot: the network, and stable storage for its acceptor. */
public interface SynodLink {

  /** What {@link #persist} has last written, or null if it never wrote; also before a restart. */
  byte @Nullable [] record();

  /** Sends, best effort; to this robot itself as well. */
  void send(RobotId to, SynodMessage message);

  /**
   * Writes the acceptor's {@code record} in place of the one before, and calls {@link
   * Synod#flushed} with {@code version}, later, once it would survive a crash. Writes are flushed in
   * order.
   */
  void persist(long version, byte[] record);
}
