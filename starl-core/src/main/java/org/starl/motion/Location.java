package org.starl.motion;

import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/** What a robot knows of its own place: the paper's {@code currentlocation}. */
public sealed interface Location {

  /** Before the first fix. */
  record Unknown() implements Location {
    @Override
    public String toString() {
      return "unknown";
    }
  }

  /**
   * A pose with its error bounds.
   *
   * @param errorMm the true position lies within this distance of the pose's
   * @param errorRad the true heading lies within this angle of the pose's
   * @param timeNs when this holds
   * @param fixNs when the newest fix that it rests on was measured
   */
  record Known(Pose pose, double errorMm, double errorRad, long timeNs, long fixNs)
      implements Location {

    public long fixAgeNs() {
      return timeNs - fixNs;
    }

    @Override
    public String toString() {
      return StrictMath.round(pose.xMm())
          + ","
          + StrictMath.round(pose.yMm())
          + " mm "
          + StrictMath.round(Angles.toDegrees(pose.headingRad()))
          + " deg +-"
          + StrictMath.round(StrictMath.ceil(errorMm))
          + " mm";
    }
  }
}
