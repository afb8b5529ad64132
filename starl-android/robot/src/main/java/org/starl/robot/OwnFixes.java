package org.starl.robot;

import org.starl.robot.create.CreateTravel;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.robot.optitrack.TrackedBody;
import org.starl.robot.optitrack.WheelPath;
import org.starl.time.Time;

/** Joins a robot's wheels and the feed of its positions, below its strand: neither waits for it. */
final class OwnFixes {

  /** Slip, and the wear of the wheels; encoders. */
  private static final double LEAST_ERROR = 0.1;

  /** A Create 1's own sums of ways and angles. */
  private static final double CREATE_1_ERROR = 0.3;

  private OwnFixes() {}

  /** The wheels get the robot's fixes, which the feed judges by the wheels' odometry, if they have any. */
  static void join(PoseFeed poses, RobotEntry entry, Wheelbase wheels, Limits limits) {
    boolean isRough =
        entry.wheels() instanceof Wheels.Create create && create.model().equals("create1");
    double least = isRough ? CREATE_1_ERROR : LEAST_ERROR;
    WheelPath path =
        new WheelPath(Math.max(least, limits.speedError()), limits.reactionMs() * Time.NS_PER_MS);
    wheels.onTravel(
        new Wheelbase.TravelReceiver() {
          @Override
          public void travelled(long atNs, CreateTravel travel, double mmPerS, boolean isTouched) {
            path.add(atNs, travel.forwardMm(), travel.turnedRad(), mmPerS, isTouched);
          }

          @Override
          public void lifted(boolean isLifted) {
            path.lift(isLifted);
          }

          @Override
          public void lost() {
            path.lose();
          }
        });
    poses.own(entry.rigidBody(), path, wheels::doubted);
    poses.onBodies(bodies -> {
      for (TrackedBody body : bodies) {
        if (body.name().equals(entry.rigidBody()) && body.fix() != null) {
          wheels.fixed(body.fix());
        }
      }
    });
  }
}
