package org.starl.robot.optitrack;

import java.net.DatagramPacket;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;

/**
 * Poses that another library receives, each with a stamp of its sender's clock: judged like lines of the
 * {@link JsonFeed}. From any thread.
 */
public class StampedFeed extends PoseFeed {

  private final JsonProtocol protocol;

  /**
   * @param tag of its lines in the log
   */
  public StampedFeed(FixBounds bounds, Clock clock, LogSink log, String tag) {
    super(clock, log, tag);
    protocol = new JsonProtocol(bounds, null, tally);
  }

  /**
   * Takes a pose.
   *
   * @param name of the body
   * @param errorMm the true position lies within this distance; at least 0
   * @param errorRad likewise the heading
   * @param atNs its time on the sender's clock
   */
  public final void offer(String name, Pose pose, double errorMm, double errorRad, long atNs) {
    publish(judged(new JsonPose(name, pose, errorMm, errorRad, atNs)));
  }

  /** Counts a pose that is not usable; the first of each reason is logged. */
  public final synchronized void drop(FeedDrop why, String what) {
    tally.received();
    tally.drop(why, what, clock.nowNs());
  }

  private synchronized List<TrackedBody> judged(JsonPose pose) {
    tally.received();
    TrackedBody body = protocol.judged(pose, clock.nowNs());
    return body == null ? List.of() : List.of(body);
  }

  /** It has no sockets. */
  @Override
  final List<TrackedBody> read(@Nullable DatagramPacket packet, long nowNs) {
    return List.of();
  }
}
