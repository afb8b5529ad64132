package org.starl.robot.optitrack;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;

/**
 * Converts JSON lines to fixes. Each robot's lines have a clock of their own, because each robot may
 * have its own sender. Pure and driven by the clock; one caller at a time.
 */
final class JsonProtocol {

  /** Largest number of robots. */
  static final int MAX_ROBOTS = 1024;

  private final FixBounds bounds;
  private final Tally tally;
  private final Map<String, Track> tracks = new LinkedHashMap<>();

  private static final class Track {
    final ClockMap clock;
    final PoseGate gate;

    Track(FixBounds bounds) {
      clock = new ClockMap(bounds.maxDelayNs());
      gate = new PoseGate(bounds);
    }
  }

  JsonProtocol(FixBounds bounds, Tally tally) {
    this.bounds = bounds;
    this.tally = tally;
  }

  /** The body in a datagram, with its fix; null if the datagram is dropped. */
  @Nullable TrackedBody received(byte[] bytes, int length, long nowNs) {
    JsonPoseParser.Result result = JsonPoseParser.parse(bytes, length);
    JsonPose line = result.pose();
    if (line == null) {
      return drop(FeedDrop.MALFORMED, "not a line of the feed: " + result.problem(), nowNs);
    }
    Track track = tracks.get(line.robot());
    if (track == null) {
      if (tracks.size() == MAX_ROBOTS) {
        return drop(FeedDrop.TOO_MANY, "more than " + MAX_ROBOTS + " robots", nowNs);
      }
      track = new Track(bounds);
      tracks.put(line.robot(), track);
    }
    track.clock.received(line.atNs(), nowNs);
    if (!track.clock.isSettled(nowNs)) {
      return drop(FeedDrop.EARLY, "the sender's clock is not known yet", nowNs);
    }
    TimeSpan when = track.clock.span(line.atNs(), line.atNs(), nowNs);
    if (nowNs - when.middleNs() > bounds.maxAgeNs()) {
      return drop(FeedDrop.STALE, line.robot() + " was measured too long ago", nowNs);
    }
    Fix fix = bounds.fix(line.pose(), line.errorMm(), line.errorRad(), when);
    return tally.isPossible(track.gate, line.robot(), fix, nowNs)
        ? new TrackedBody(line.robot(), -1, fix)
        : null;
  }

  private @Nullable TrackedBody drop(FeedDrop why, String what, long nowNs) {
    tally.drop(why, what, nowNs);
    return null;
  }
}
