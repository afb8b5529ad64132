package org.starl.primitives.agreement;

import org.starl.id.RobotId;

/**
 * A protocol that stands on a {@link Synod}, as its robot sees it. Pure and clock-driven: times are
 * now, in ns; {@link #timer} is due at {@link #wakeAtNs}, which every call may move.
 */
public interface SynodProtocol {

  void received(RobotId from, SynodMessage message, long nowNs);

  /** As {@link Synod#flushed}. */
  void flushed(long version, long nowNs);

  void timer(long nowNs);

  /** When {@link #timer} is due; {@code Long.MAX_VALUE} for never. */
  long wakeAtNs();
}
