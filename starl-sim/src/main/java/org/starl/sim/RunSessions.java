package org.starl.sim;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.session.KnownStarts;
import org.starl.session.Sessions;

/** The sessions of a run's robots, which know at once when another robot has started again. */
final class RunSessions {

  private final @Nullable DeploymentKey key;
  private final Map<RobotId, Integer> starts = new TreeMap<>();
  private final SealWatch watch = new SealWatch();

  /**
   * @param key null: datagrams are not sealed
   */
  RunSessions(@Nullable DeploymentKey key) {
    this.key = key;
  }

  /** The sessions of a robot that starts now; null if datagrams are not sealed. */
  @Nullable Sessions started(RobotId robot) {
    DeploymentKey root = key;
    if (root == null) {
      return null;
    }
    int start = starts.merge(robot, 1, Integer::sum);
    return new KnownStarts(
        peer -> root.pairKey(robot, peer),
        robot,
        start,
        peer -> starts.getOrDefault(peer, 0),
        starts::keySet,
        watch);
  }
}
