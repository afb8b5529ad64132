package org.starl.motion;

import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/** The robot's knowledge of its own position: the paper's {@code currentlocation}. */
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
   * @param errorMm bound of the position error
   * @param errorRad bound of the heading error
   * @param timeNs time of the pose and its bounds
   * @param fixNs measurement time of the newest fix that was used
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
