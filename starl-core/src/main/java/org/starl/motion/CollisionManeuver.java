package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/**
 * The reaction to a bump, by its {@link CollisionPolicy}: a short sequence of phases, restarted by
 * another bump. Pure, as part of its automaton.
 */
final class CollisionManeuver {

  private static final double FOLLOW_TURN_RAD = StrictMath.PI / 4;
  private static final double FOLLOW_RADIUS_MM = 320;
  private static final double RANDOM_TURN_RAD = StrictMath.PI / 2;

  private final MotionParameters p;
  private final Rng rng;

  private MotionState phase = MotionState.INIT;
  private Bumps side = Bumps.NONE;
  private long sinceNs;
  private double wantedRad;
  private boolean failed;
  private boolean onlyTurns;
  private boolean hasBumped;

  CollisionManeuver(MotionParameters parameters, Rng rng) {
    this.p = parameters;
    this.rng = rng;
  }

  boolean isUnderWay() {
    return phase != MotionState.INIT;
  }

  MotionState state() {
    return phase;
  }

  boolean hasFailed() {
    return failed;
  }

  /** Whether it has reacted to a bump. */
  boolean hasBumped() {
    return hasBumped;
  }

  /**
   * Starts, continues or ends the manoeuvre; once {@link #isUnderWay} is false, the returned
   * command has no meaning.
   */
  WheelCommand step(Pose pose, Bumps bumps, long nowNs) {
    if (bumps.any() && phase != MotionState.COLLISION_BACK && phase != MotionState.COLLISION_TURN) {
      begin(bumps, nowNs);
    }
    return switch (phase) {
      case COLLISION_BACK -> back(pose, nowNs);
      case COLLISION_TURN -> turn(pose, bumps, nowNs);
      case COLLISION_ARC -> arc(pose, nowNs);
      case COLLISION_STRAIGHT -> straight(nowNs);
      default -> WheelCommand.STOP;
    };
  }

  /**
   * Begins to wander: turns by a random angle, then drives straight.
   *
   * @param mayDrive otherwise it only turns
   */
  void wander(Pose pose, boolean mayDrive, long nowNs) {
    wantedRad = pose.headingRad() + randomTurnRad();
    onlyTurns = !mayDrive;
    enter(MotionState.COLLISION_TURN, nowNs);
  }

  /** Ends the manoeuvre where it is. */
  void giveUp() {
    phase = MotionState.INIT;
  }

  private void begin(Bumps bumps, long nowNs) {
    side = bumps;
    onlyTurns = false;
    hasBumped = true;
    switch (p.reaction()) {
      case BUMPERCARS -> enter(MotionState.INIT, nowNs);
      case STOP_ON_COLLISION -> fail();
      case USE_COLAVOID -> enter(MotionState.COLLISION_TURN, nowNs);
      case USE_COLBACK -> enter(MotionState.COLLISION_BACK, nowNs);
    }
  }

  private void enter(MotionState next, long nowNs) {
    phase = next;
    sinceNs = nowNs;
  }

  private void fail() {
    phase = MotionState.INIT;
    failed = true;
  }

  private boolean hasLasted(long ms, long nowNs) {
    return nowNs - sinceNs >= ms * NS_PER_MS;
  }

  private WheelCommand back(Pose pose, long nowNs) {
    if (!hasLasted(p.collisionBackMs(), nowNs)) {
      return new WheelCommand(-p.linSpeedMaxMmPerS() / 2, 0);
    }
    if (p.robotType() == RobotType.GOAL) {
      fail();
      return WheelCommand.STOP;
    }
    double turnRad =
        p.robotType() == RobotType.DISCOVERY ? awayFromSide() * FOLLOW_TURN_RAD : randomTurnRad();
    wantedRad = pose.headingRad() + turnRad;
    enter(MotionState.COLLISION_TURN, nowNs);
    return turnToWanted(pose, nowNs);
  }

  private double randomTurnRad() {
    return (2 * rng.nextDouble() - 1) * RANDOM_TURN_RAD;
  }

  private WheelCommand turn(Pose pose, Bumps bumps, long nowNs) {
    if (p.reaction() == CollisionPolicy.USE_COLBACK) {
      return turnToWanted(pose, nowNs);
    }
    if (bumps.any() || !hasLasted(p.collisionTurnMs(), nowNs)) {
      return new WheelCommand(0, awayFromSide() * p.turnSpeedMaxRadPerS());
    }
    enter(MotionState.COLLISION_STRAIGHT, nowNs);
    return straight(nowNs);
  }

  private WheelCommand turnToWanted(Pose pose, long nowNs) {
    double offRad = Angles.difference(wantedRad, pose.headingRad());
    if (Math.abs(offRad) > p.smallTurnAngleRad()) {
      double speed = Math.min(p.turnSpeedMaxRadPerS(), Math.abs(offRad) / p.reachS());
      return new WheelCommand(0, StrictMath.copySign(speed, offRad));
    }
    if (onlyTurns) {
      enter(MotionState.INIT, nowNs);
      return WheelCommand.STOP;
    }
    if (p.robotType() == RobotType.DISCOVERY) {
      // Turns back towards the obstacle, by twice the turn.
      wantedRad = pose.headingRad() - awayFromSide() * 2 * FOLLOW_TURN_RAD;
      enter(MotionState.COLLISION_ARC, nowNs);
      return arc(pose, nowNs);
    }
    enter(MotionState.COLLISION_STRAIGHT, nowNs);
    return straight(nowNs);
  }

  private WheelCommand arc(Pose pose, long nowNs) {
    double offRad = Angles.difference(wantedRad, pose.headingRad());
    double toWards = -awayFromSide();
    if (offRad * toWards > p.smallTurnAngleRad()) {
      double speed = p.linSpeedMinMmPerS();
      return new WheelCommand(speed, toWards * speed / FOLLOW_RADIUS_MM);
    }
    enter(MotionState.COLLISION_STRAIGHT, nowNs);
    return straight(nowNs);
  }

  private WheelCommand straight(long nowNs) {
    if (!hasLasted(p.collisionStraightMs(), nowNs)) {
      return new WheelCommand(p.linSpeedMinMmPerS(), 0);
    }
    enter(MotionState.INIT, nowNs);
    return WheelCommand.STOP;
  }

  /**
   * Turning direction away from the obstacle: 1 (counter-clockwise) if it is to the right or ahead,
   * else -1.
   */
  private double awayFromSide() {
    return side == Bumps.LEFT ? -1 : 1;
  }
}
