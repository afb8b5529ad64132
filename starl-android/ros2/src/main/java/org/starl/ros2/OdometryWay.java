package org.starl.ros2;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;
import org.starl.robot.create.CreateTravel;
import org.starl.robot.file.Limits;
import org.starl.time.Time;

/**
 * The way and the turns of a base, from the poses of its odometry: they lose nothing with a lost message,
 * as a sum of speeds would. A step that no wheels make is a new beginning. Pure.
 */
final class OdometryWay {

  /** A step may be so many times what the speed limit allows: stamps are rough. */
  private static final double ROOM = 2;

  private static final double ROOM_MM = 50;

  private final double maxMmPerS;
  private @Nullable Pose last;
  private long lastNs;
  private CreateTravel travel = CreateTravel.NONE;

  OdometryWay(Limits limits) {
    maxMmPerS = (1 + limits.speedError()) * limits.speedMmPerS();
  }

  /** Takes the next message; returns whether it continues the way. */
  boolean add(Messages.Odometry odometry) {
    Pose before = last;
    Pose now = odometry.pose();
    long elapsedNs = odometry.stampNs() - lastNs;
    last = now;
    lastNs = odometry.stampNs();
    if (before == null || now == null || elapsedNs <= 0) {
      return false;
    }
    if (before.at().distanceMm(now.at()) > ROOM * maxMmPerS * Time.seconds(elapsedNs) + ROOM_MM) {
      return false;
    }
    double turnRad = Angles.difference(now.headingRad(), before.headingRad());
    double middleRad = before.headingRad() + turnRad / 2;
    double forwardMm =
        (now.xMm() - before.xMm()) * StrictMath.cos(middleRad)
            + (now.yMm() - before.yMm()) * StrictMath.sin(middleRad);
    travel = new CreateTravel(travel.forwardMm() + forwardMm, travel.turnedRad() + turnRad);
    return true;
  }

  /** The way so far. */
  CreateTravel travel() {
    return travel;
  }
}
