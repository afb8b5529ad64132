package org.starl.primitives.motion;

import static org.starl.time.Time.NS_PER_S;

import org.starl.geometry.Nowhere;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;

/** Follows a true body between two events, and finds when it enters a region. */
final class BodyPath {

  /** A tolerance, since a body may touch a border, and a recorded trace rounds to 0.001 mm. */
  static final double ROUNDING_MM = 0.01;

  /** The least step: a part of the path inside a region is found if it is longer. */
  private static final double GRAIN_MM = 0.25;

  private BodyPath() {}

  /**
   * The first time at which a part of the body is in the region; -1 if there is none. The body's
   * motion must not change between the two times.
   *
   * @param mmPerS the body's speed, at least 0
   */
  static long entersNs(
      Bodies bodies, RobotId robot, double mmPerS, Region region, long fromNs, long toNs) {
    if (region instanceof Nowhere) {
      return -1;
    }
    double radiusMm = bodies.radiusMm(robot);
    long atNs = fromNs;
    while (true) {
      Pose pose = bodies.poseAt(robot, atNs);
      double gapMm = region.distanceMm(pose.at()) - radiusMm;
      if (gapMm < -ROUNDING_MM) {
        return atNs;
      }
      if (atNs >= toNs || mmPerS == 0) {
        return -1;
      }
      // No point of the body comes closer by more than the distance driven.
      double freeNs = Math.max(gapMm, GRAIN_MM) / mmPerS * NS_PER_S;
      atNs = freeNs < toNs - atNs ? atNs + (long) freeNs : toNs;
    }
  }
}
