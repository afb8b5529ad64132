package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.world.Body;

/**
 * A foreign body that follows one robot, or parks in front of it. None appears if there is no free
 * place near the robot, or while the robot is off the floor.
 */
final class Intruder {

  private static final long STEP_NS = 50_000_000;
  private static final int TRIES = 64;
  private static final double NEAREST_RADII = 2.5;
  private static final double FARTHEST_RADII = 7;
  private static final double ALIGNED_RAD = 0.3;
  private static final double TURN_RAD_PER_S = 2;

  private final FaultTarget run;
  private final RobotId target;
  private final double speedMmPerS;
  private final @Nullable Body body;
  private boolean hasLeft;

  private Intruder(RobotId name, RobotId target, double speedMmPerS, FaultContext context) {
    this.run = context.target();
    this.target = target;
    this.speedMmPerS = speedMmPerS;
    body = enter(name, context.rng().fork(name.name()));
    if (speedMmPerS > 0 && body != null) {
      step(body);
    }
  }

  /**
   * An intruder for each affected robot; they disappear when the fault ends.
   *
   * @param speedMmPerS speed towards the robot; 0 for a parked body
   */
  static FaultAction fault(double speedMmPerS) {
    return context -> {
      List<Intruder> intruders = new ArrayList<>();
      for (RobotId robot : context.robots()) {
        if (context.target().body(robot) != null) {
          RobotId name = new RobotId("intruder" + context.number() + "-" + intruders.size());
          intruders.add(new Intruder(name, robot, speedMmPerS, context));
        }
      }
      return () -> intruders.forEach(Intruder::leave);
    };
  }

  private void leave() {
    hasLeft = true;
    if (body != null) {
      run.world().remove(body);
    }
  }

  private @Nullable Body enter(RobotId name, Rng rng) {
    Body victim = run.body(target);
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
      Point offset =
          new Point(distanceMm * StrictMath.cos(direction), distanceMm * StrictMath.sin(direction));
      Pose pose =
          Pose.of(victim.pose().at().plus(offset), Angles.normalize(direction + StrictMath.PI));
      if (run.world().isFree(pose, radiusMm)) {
        return run.world().add(name, pose, radiusMm);
      }
    }
    return null;
  }

  private void step(Body intruder) {
    if (hasLeft) {
      return;
    }
    Body victim = run.body(target);
    intruder.drive(
        victim == null ? WheelCommand.STOP : towards(intruder.pose(), victim.pose().at()));
    run.at(run.nowNs() + STEP_NS, () -> step(intruder));
  }

  private WheelCommand towards(Pose from, Point to) {
    double wantedRad = to.minus(from.at()).angleRad();
    double turn = Angles.difference(wantedRad, from.headingRad());
    return Math.abs(turn) > ALIGNED_RAD
        ? new WheelCommand(0, Math.copySign(TURN_RAD_PER_S, turn))
        : new WheelCommand(speedMmPerS, TURN_RAD_PER_S * turn);
  }
}
