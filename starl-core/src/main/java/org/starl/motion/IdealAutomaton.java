package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Sines;

/**
 * Ideal motion: one period to turn by any angle; straight at full speed; in the last period exactly
 * the speed that ends on the target. A bump fails, except under BUMPERCARS.
 */
final class IdealAutomaton implements MotionAutomaton {

  // With exact fixes one turn is enough. With noisy fixes, another turn is worth its period only if
  // the path misses the target by this fraction of the goal radius, and by this angle.
  private static final double MISS = 0.5;
  private static final double OFF_RAD = 0.1;

  private static final double EXACT_MM = 1e-6;
  private static final double EXACT_RAD = 1e-9;

  private final Point target;
  private final boolean turnOnly;
  private final MotionParameters p;

  private MotionState state = MotionState.INIT;
  private MotionFlag status = MotionFlag.MOVING;
  private WheelCommand last = WheelCommand.STOP;
  private boolean onLastLeg;

  IdealAutomaton(Point target, boolean turnOnly, MotionParameters parameters) {
    this.target = target;
    this.turnOnly = turnOnly;
    this.p = parameters;
  }

  @Override
  public WheelCommand step(Pose pose, Bumps bumps, long nowNs) {
    if (status == MotionFlag.MOVING) {
      last = bumps.any() && p.collisionPolicy() != CollisionPolicy.BUMPERCARS ? fail() : go(pose);
    }
    return last;
  }

  @Override
  public MotionFlag status() {
    return status;
  }

  @Override
  public MotionState state() {
    return state;
  }

  private WheelCommand go(Pose pose) {
    Point way = target.minus(pose.at());
    double distanceMm = way.normMm();
    if (!turnOnly && (distanceMm <= EXACT_MM || (onLastLeg && distanceMm <= p.goalRadiusMm()))) {
      return arrive();
    }
    double offRad = distanceMm == 0 ? 0 : Angles.difference(way.angleRad(), pose.headingRad());
    if (turnOnly) {
      return turnTowards(offRad);
    }
    double aheadMm = distanceMm * Sines.cos(offRad);
    boolean turns =
        state == MotionState.INIT ? Math.abs(offRad) > EXACT_RAD : isOff(offRad, distanceMm);
    onLastLeg = false;
    if (turns) {
      state = MotionState.TURN;
      return new WheelCommand(0, offRad / p.reachS());
    }
    state = MotionState.STRAIGHT;
    double speed = Math.min(p.linSpeedMaxMmPerS(), aheadMm / p.reachS());
    onLastLeg = speed < p.linSpeedMaxMmPerS();
    return new WheelCommand(speed, 0);
  }

  private WheelCommand turnTowards(double offRad) {
    double enoughRad = state == MotionState.INIT ? EXACT_RAD : p.smallTurnAngleRad();
    if (Math.abs(offRad) <= enoughRad) {
      return arrive();
    }
    state = MotionState.TURN;
    return new WheelCommand(0, offRad / p.reachS());
  }

  private boolean isOff(double offRad, double distanceMm) {
    boolean isBehind = Math.abs(offRad) >= StrictMath.PI / 2;
    double asideMm = distanceMm * Math.abs(Sines.sin(offRad));
    return isBehind || (Math.abs(offRad) > OFF_RAD && asideMm > MISS * p.goalRadiusMm());
  }

  private WheelCommand arrive() {
    state = MotionState.GOAL;
    status = MotionFlag.DONE;
    return p.stopAtDestination() ? WheelCommand.STOP : last;
  }

  private WheelCommand fail() {
    state = MotionState.FAILED;
    status = MotionFlag.FAIL;
    return WheelCommand.STOP;
  }
}
