package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.platform.DeploymentKey;
import org.starl.robot.realtime.RealClock;

/**
 * Converts JSON lines, or poses with a sender's stamp, to fixes. Each robot's have a clock of their own,
 * because each robot may have its own sender. Pure and driven by the clock; one caller at a time.
 */
final class JsonProtocol {

  /** Largest difference between the dates of an authenticated sender and of the feed. */
  static final long MOST_DATE_ERROR_NS = 5 * NS_PER_S;

  /** Largest number of robots. */
  static final int MAX_ROBOTS = 1024;

  private final FixBounds bounds;
  private final Tally tally;
  private final @Nullable JsonSeal seal;
  private final Map<String, Track> tracks = new LinkedHashMap<>();

  private static final class Track {
    final ClockMap clock;
    final PoseGate gate;
    long newestAtNs = Long.MIN_VALUE;

    Track(FixBounds bounds) {
      clock = new ClockMap(bounds.maxDelayNs());
      gate = new PoseGate(bounds);
    }
  }

  /** @param key null: lines are not authenticated */
  JsonProtocol(FixBounds bounds, @Nullable DeploymentKey key, Tally tally) {
    this.bounds = bounds;
    this.tally = tally;
    this.seal = key == null ? null : new JsonSeal(key);
  }

  /** The body in a datagram, with its fix; null if the datagram is dropped. */
  @Nullable TrackedBody received(byte[] bytes, int length, long nowNs) {
    int lineLength = seal == null ? length : seal.lineLength(bytes, length);
    if (lineLength < 0) {
      return drop(FeedDrop.FORGED, "a line without the code that the feed's key gives it", nowNs);
    }
    JsonPoseParser.Result result = JsonPoseParser.parse(bytes, lineLength);
    JsonPose line = result.pose();
    if (line == null) {
      return drop(FeedDrop.MALFORMED, "not a line of the feed: " + result.problem(), nowNs);
    }
    return judged(line, nowNs);
  }

  /** The body of a pose, with its fix; null if it is dropped. */
  @Nullable TrackedBody judged(JsonPose line, long nowNs) {
    Track track = tracks.get(line.robot());
    if (seal != null && !isNew(track, line, nowNs)) {
      return drop(
          FeedDrop.REPLAYED,
          "a line of "
              + line.robot()
              + " is older than one before it, or more than 5 s off this machine's date",
          nowNs);
    }
    if (track == null) {
      if (tracks.size() == MAX_ROBOTS) {
        return drop(FeedDrop.TOO_MANY, "more than " + MAX_ROBOTS + " robots", nowNs);
      }
      track = new Track(bounds);
      tracks.put(line.robot(), track);
    }
    track.newestAtNs = line.atNs();
    track.clock.received(line.atNs(), nowNs);
    if (!track.clock.isSettled(nowNs)) {
      return drop(FeedDrop.EARLY, "the sender's clock is not known yet", nowNs);
    }
    TimeSpan when = track.clock.span(line.atNs(), line.atNs(), nowNs);
    if (when.earliestNs() > when.latestNs()) {
      return drop(FeedDrop.IMPLAUSIBLE, line.robot() + " was measured in the future", nowNs);
    }
    if (nowNs - when.middleNs() > bounds.maxAgeNs()) {
      return drop(FeedDrop.STALE, line.robot() + " was measured too long ago", nowNs);
    }
    Fix fix = bounds.fix(line.pose(), line.errorMm(), line.errorRad(), when);
    return tally.admit(track.gate, line.robot(), fix, nowNs)
        ? new TrackedBody(line.robot(), -1, fix)
        : null;
  }

  private static boolean isNew(@Nullable Track track, JsonPose line, long nowNs) {
    return track == null
        ? Math.abs(line.atNs() - RealClock.DATE_ORIGIN_UNIX_NS - nowNs) <= MOST_DATE_ERROR_NS
        : line.atNs() > track.newestAtNs;
  }

  private @Nullable TrackedBody drop(FeedDrop why, String what, long nowNs) {
    tally.drop(why, what, nowNs);
    return null;
  }
}
