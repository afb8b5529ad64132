package org.starl.robot.udp;

import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.session.Session;
import org.starl.session.Sessions;

/** The sessions that a robot has opened with others. Strand only. */
public final class OpenSessions implements Sessions {

  private final SortedMap<RobotId, Session> sessions = new TreeMap<>();

  @Override
  public @Nullable Session with(RobotId peer) {
    return sessions.get(peer);
  }

  @Override
  public Iterable<RobotId> peers() {
    return sessions.keySet();
  }

  /** Replaces the session with {@code peer}, which has started again. */
  void open(RobotId peer, Session session) {
    sessions.put(peer, session);
  }
}
