package org.starl.session;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/** A robot's sessions with other robots, which seal its datagrams. Strand only. */
public interface Sessions {

  /**
   * The present session with {@code peer}; null if there is none yet: nothing can be sent to it, and
   * nothing from it is accepted. It changes when {@code peer} starts again, and never back.
   */
  @Nullable Session with(RobotId peer);

  /** The robots with which there may be a session, in order: the receivers of a broadcast. */
  Iterable<RobotId> peers();
}
