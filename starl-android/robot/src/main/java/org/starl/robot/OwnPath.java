package org.starl.robot;

import org.starl.robot.create.CreateTravel;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;
import org.starl.robot.optitrack.WheelPath;
import org.starl.time.Time;

/** Joins the odometry of a robot's wheels to the feed that judges its fixes by them. */
final class OwnPath {

  /** Slip, and the wear of the wheels; encoders. */
  private static final double LEAST_ERROR = 0.1;

  /** A Create 1's own sums of ways and angles. */
  private static final double CREATE_1_ERROR = 0.3;

  private OwnPath() {}

  /** The path of these wheels from now on; without odometry it has no states. */
  static WheelPath of(Wheelbase wheels, Wheels kind, Limits limits) {
    boolean isRough = kind instanceof Wheels.Create create && create.model().equals("create1");
    double least = isRough ? CREATE_1_ERROR : LEAST_ERROR;
    WheelPath path =
        new WheelPath(Math.max(least, limits.speedError()), limits.reactionMs() * Time.NS_PER_MS);
    wheels.onTravel(
        new Wheelbase.TravelReceiver() {
          @Override
          public void travelled(long atNs, CreateTravel travel, double mmPerS, boolean isMoved) {
            path.add(atNs, travel.forwardMm(), travel.turnedRad(), mmPerS, isMoved);
          }

          @Override
          public void lost() {
            path.lose();
          }
        });
    return path;
  }
}
