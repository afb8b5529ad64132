package org.starl.robot.udp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.session.PairKey;

/**
 * The keys that one robot shares with each robot of its deployment, itself included: with those it
 * recognises a second machine of its own name. Immutable.
 */
public final class PeerKeys {

  private final Map<RobotId, List<PairKey>> keys;

  private PeerKeys(Map<RobotId, List<PairKey>> keys) {
    this.keys = keys;
  }

  /** All keys follow from one key, which every robot has. */
  public static PeerKeys shared(DeploymentKey key, RobotId self, Iterable<RobotId> robots) {
    Map<RobotId, List<PairKey>> keys = new TreeMap<>();
    for (RobotId robot : robots) {
      keys.put(robot, Arrays.asList(key.pairKey(self, robot)));
    }
    return new PeerKeys(keys);
  }

  /**
   * Each robot has a key of its own.
   *
   * @param own this robot's
   * @param published the public keys of each robot, the newest first
   */
  public static PeerKeys separate(RobotKey own, Map<RobotId, List<PublicRobotKey>> published) {
    Map<RobotId, List<PairKey>> keys = new TreeMap<>();
    published.forEach((robot, list) -> {
      List<PairKey> pairs = new ArrayList<>();
      list.forEach(key -> pairs.add(own.pairKey(key)));
      keys.put(robot, pairs);
    });
    return new PeerKeys(keys);
  }

  /** The keys with that robot, the newest first; none if the deployment does not have it. */
  List<PairKey> with(RobotId robot) {
    return keys.getOrDefault(robot, new ArrayList<>());
  }
}
