package org.starl.sim.fault;

import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.world.Body;

/** A body of the world that follows one robot. */
final class Intruder {

  private static final long STEP_NS = 50_000_000;
  private static final int TRIES = 64;
  private static final double NEAREST_RADII = 2.5;
  private static final double FARTHEST_RADII = 7;
  private static final double ALIGNED_RAD = 0.3;
  private static final double TURN_RAD_PER_S = 2;

  private final FaultTarget ward;
  private final RobotId target;
  private final double speedMmPerS;
  private final @Nullable Body body;
  private boolean hasLeft;

  Intruder(RobotId name, RobotId target, double speedMmPerS, FaultContext onset) {
    this.ward = onset.ward();
    this.target = target;
    this.speedMmPerS = speedMmPerS;
    body = enter(name, onset.rng().fork(name.name()));
    if (speedMmPerS > 0 && body != null) {
      step(body);
    }
  }

  void leave() {
    hasLeft = true;
    if (body != null) {
      ward.world().remove(body);
    }
  }

  private @Nullable Body enter(RobotId name, Rng rng) {
    Body victim = ward.body(target);
    if (victim == null) {
      return null;
    }
    double radiusMm = victim.radiusMm();
    for (int i = 0; i < TRIES; i++) {
      // Straight ahead first: there it blocks the robot or hits it head-on.
      double spread = StrictMath.PI * i / TRIES;
      double direction = victim.pose().headingRad() + spread * (2 * rng.nextDouble() - 1);
      double distanceMm =
          radiusMm * (NEAREST_RADII + (FARTHEST_RADII - NEAREST_RADII) * rng.nextDouble());
      Point at =
          victim
              .pose()
              .at()
              .plus(
                  new Point(
                      distanceMm * StrictMath.cos(direction),
                      distanceMm * StrictMath.sin(direction)));
      Pose pose = new Pose(at.xMm(), at.yMm(), Angles.normalize(direction + StrictMath.PI));
      if (ward.world().isFree(pose, radiusMm)) {
        return ward.world().add(name, pose, radiusMm);
      }
    }
    return null;
  }

  private void step(Body mine) {
    if (hasLeft) {
      return;
    }
    Body victim = ward.body(target);
    mine.drive(victim == null ? WheelCommand.STOP : towards(mine.pose(), victim.pose().at()));
    ward.at(ward.nowNs() + STEP_NS, () -> step(mine));
  }

  private WheelCommand towards(Pose from, Point to) {
    double wantedRad = to.minus(from.at()).angleRad();
    double turn = Angles.difference(wantedRad, from.headingRad());
    return Math.abs(turn) > ALIGNED_RAD
        ? new WheelCommand(0, Math.copySign(TURN_RAD_PER_S, turn))
        : new WheelCommand(speedMmPerS, TURN_RAD_PER_S * turn);
  }
}
