package org.starl.primitives.motion;

import org.starl.geometry.Nowhere;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;

/** Follows a true body between two events, and finds where it comes too near to a region. */
final class BodyPath {

  /** Who touches a border is not inside; a recorded trace rounds places to 0.001 mm. */
  static final double ROUNDING_MM = 0.01;

  /** No sliver of a path that is longer lies within a region unseen. */
  private static final double GRAIN_MM = 0.25;

  private static final double NS_PER_S = 1e9;

  private BodyPath() {}

  /**
   * The first time, from one to another between which the body's motion does not change, at which
   * part of it is in the region; -1 if there is none.
   *
   * @param mmPerS how fast it drives, at least 0
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
      // No point of the body comes nearer by more than the way that it drives.
      double freeNs = Math.max(gapMm, GRAIN_MM) / mmPerS * NS_PER_S;
      atNs = freeNs < toNs - atNs ? atNs + (long) freeNs : toNs;
    }
  }
}
