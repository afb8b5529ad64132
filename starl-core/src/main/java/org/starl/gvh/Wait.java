package org.starl.gvh;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.trace.Instance;

/**
 * What one part of a robot waits for, or holds: for people who ask why a run does not end.
 *
 * @param source the primitive and its instance, as in {@code mutex/crossing}
 * @param what in words: {@code requests [A, C]; answers missing}
 * @param on the robots that must act first; empty if it waits for none
 */
public record Wait(Instance source, String what, List<RobotId> on) {

  public Wait {
    on = List.copyOf(on);
  }

  @Override
  public String toString() {
    return source + ": " + what + (on.isEmpty() ? "" : " from " + on);
  }
}
