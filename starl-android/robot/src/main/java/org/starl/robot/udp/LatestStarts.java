package org.starl.robot.udp;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.platform.StableStorage;
import org.starl.session.Start;

/** The latest start of each other robot that this robot has heard, in its stable storage. */
final class LatestStarts {

  private static final String KEY = "starl.peer.";

  private LatestStarts() {}

  /** The starts in the storage. Strand only. */
  static Map<RobotId, Start> of(StableStorage stable, Iterable<RobotId> robots) {
    Map<RobotId, Start> starts = new TreeMap<>();
    for (RobotId robot : robots) {
      byte[] stored = stable.get(KEY + robot);
      if (stored != null && stored.length == Start.BYTES) {
        starts.put(robot, Start.read(ByteBuffer.wrap(stored)));
      }
    }
    return starts;
  }

  /** Writes a later start. Strand only. */
  static void put(StableStorage stable, RobotId robot, Start start, Runnable flushed) {
    ByteBuffer bytes = ByteBuffer.allocate(Start.BYTES);
    start.write(bytes);
    stable.put(KEY + robot, bytes.array(), flushed);
  }
}
