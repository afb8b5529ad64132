package org.starl.ros2;

import java.io.IOException;
import java.util.Collection;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RosTopic;
import org.starl.robot.optitrack.FeedDrop;
import org.starl.robot.optitrack.FixBounds;
import org.starl.robot.optitrack.StampedFeed;
import org.starl.time.Time;

/** Positions from topics, one for each robot. */
final class RosPoses extends StampedFeed {

  /** No network holds up a message for longer, and no clock is set by less. */
  private static final long JUMP_NS = Time.NS_PER_S;

  private final Positions.Ros2 positions;
  private final RosType type;
  private final RosNode node;
  private final Clock clock;

  /** How much later than its stamp each body's last message came. */
  private final Map<String, Long> delaysNs = new ConcurrentSkipListMap<>();

  private RosPoses(
      Positions.Ros2 positions, RosNode node, FixBounds bounds, Clock clock, LogSink log) {
    super(bounds, clock, log, "ros2 poses");
    this.positions = positions;
    this.node = node;
    this.clock = clock;
    type = RosType.of(positions.topic().type());
  }

  static RosPoses open(
      Positions.Ros2 positions,
      Collection<String> bodies,
      FixBounds bounds,
      Clock clock,
      LogSink log)
      throws IOException {
    RosPoses poses =
        new RosPoses(positions, RosNode.open("starl_poses", clock, log), bounds, clock, log);
    for (String body : bodies) {
      RosTopic topic = positions.topic().of(body);
      poses.node.subscribe(topic, true, message -> poses.take(body, topic.name(), message));
    }
    return poses;
  }

  private void take(String body, String topic, Cdr message) {
    Messages.Measured measured = Messages.measured(message, type);
    if (!measured.frame().equals(positions.frame())) {
      drop(
          FeedDrop.FOREIGN,
          String.format(
              "%s: its frame is '%s', not positions.frame '%s': no position",
              topic, measured.frame(), positions.frame()));
    } else if (measured.pose() == null || measured.stampNs() == 0) {
      drop(FeedDrop.IMPLAUSIBLE, topic + ": no possible pose, or no stamp");
    } else if (hasJumped(body, measured.stampNs())) {
      drop(FeedDrop.OUTDATED, topic + ": its stamps jump: no fix until they are steady");
    } else {
      double sigmas = positions.sigmas();
      offer(
          body,
          measured.pose(),
          sigmas * measured.sigmaMm(),
          sigmas * measured.sigmaRad(),
          measured.stampNs());
    }
  }

  private boolean hasJumped(String body, long stampNs) {
    long delayNs = clock.nowNs() - stampNs;
    Long before = delaysNs.put(body, delayNs);
    return before != null && Math.abs(delayNs - before) > JUMP_NS;
  }

  @Override
  public void close() {
    node.close();
    super.close();
  }
}
