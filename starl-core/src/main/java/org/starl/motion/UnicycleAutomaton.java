package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Sines;
import org.starl.random.Rng;

/**
 * The original StarL's motion automaton: turn on the spot, then drive straight with small
 * corrections, or start near the target with an arc. States, parameters and transitions are the
 * original's. Differences: no step commands more than is needed to reach the target or the wanted
 * heading, wheel error and reaction time included (175 mm/s for 60 ms are 10.5 mm, which would
 * orbit a goal radius of 10 mm); and a bump is never an arrival.
 */
final class UnicycleAutomaton implements MotionAutomaton {

  private final Point target;
  private final boolean turnOnly;
  private final boolean mayWander;
  private final MotionParameters p;
  private final CollisionManeuver collision;

  private MotionState state = MotionState.INIT;
  private MotionFlag status = MotionFlag.MOVING;
  private WheelCommand last = WheelCommand.STOP;
  // Bumped since before the command was given: the robot must be able to turn away from that
  // object.
  private boolean bumpedFromStart;
  private boolean stepped;

  // Distance and bearing of the target from the robot, in this step.
  private double distanceMm;
  private double bearingRad;

  /**
   * @param mayWander whether a random mover may drive aside
   */
  UnicycleAutomaton(
      Point target, boolean turnOnly, boolean mayWander, MotionParameters parameters, Rng rng) {
    this.target = target;
    this.turnOnly = turnOnly;
    this.mayWander = mayWander;
    this.p = parameters;
    this.collision = new CollisionManeuver(parameters, rng);
  }

  @Override
  public WheelCommand step(Pose pose, Bumps bumps, long nowNs) {
    look(pose);
    if (!stepped && !turnOnly && p.robotType() == RobotType.RANDOM_MOVER) {
      collision.wander(pose, mayWander, nowNs);
    }
    noteBumps(bumps);
    WheelCommand command =
        collision.isUnderWay() || reactsTo(bumps) ? collide(pose, bumps, nowNs) : drive();
    if (mayNot(command, bumps)) {
      command = collide(pose, bumps, nowNs);
    }
    last = command;
    return command;
  }

  @Override
  public MotionFlag status() {
    return status;
  }

  @Override
  public boolean givesUpManeuver() {
    boolean gives = collision.isUnderWay() && p.robotType() != RobotType.GOAL;
    if (gives) {
      collision.giveUp();
    }
    return gives;
  }

  @Override
  public boolean goesOnAfterBump() {
    return collision.hasBumped() && p.robotType() != RobotType.GOAL && p.collisionPolicy().fails();
  }

  @Override
  public MotionState state() {
    return collision.isUnderWay() ? collision.state() : state;
  }

  private void look(Pose pose) {
    double dx = target.xMm() - pose.xMm();
    double dy = target.yMm() - pose.yMm();
    distanceMm = Math.sqrt(dx * dx + dy * dy);
    bearingRad =
        distanceMm == 0 ? 0 : Angles.difference(StrictMath.atan2(dy, dx), pose.headingRad());
  }

  private void noteBumps(Bumps bumps) {
    bumpedFromStart = bumps.any() && (bumpedFromStart || !stepped);
    stepped = true;
  }

  private boolean reactsTo(Bumps bumps) {
    return bumps.any()
        && !bumpedFromStart
        && status == MotionFlag.MOVING
        && p.reaction() != CollisionPolicy.BUMPERCARS;
  }

  /** If it touched an object at the start, it may turn, but not drive. */
  private boolean mayNot(WheelCommand command, Bumps bumps) {
    return bumps.any()
        && bumpedFromStart
        && !collision.isUnderWay()
        && command.linearMmPerS() > 0
        && p.reaction() != CollisionPolicy.BUMPERCARS;
  }

  private WheelCommand collide(Pose pose, Bumps bumps, long nowNs) {
    bumpedFromStart = false;
    WheelCommand command = collision.step(pose, bumps, nowNs);
    if (collision.hasFailed()) {
      state = MotionState.FAILED;
      status = MotionFlag.FAIL;
    } else if (!collision.isUnderWay()) {
      state = MotionState.INIT;
      return drive();
    }
    return command;
  }

  private WheelCommand drive() {
    if (status != MotionFlag.MOVING) {
      return status == MotionFlag.DONE && !p.stopAtDestination() ? last : WheelCommand.STOP;
    }
    state = next();
    return switch (state) {
      case TURN -> new WheelCommand(0, turnSpeed());
      case STRAIGHT -> new WheelCommand(forwardSpeed(p.linSpeedMaxMmPerS()), 0);
      case SMALLTURN -> arc(0.5, p.linSpeedMaxMmPerS());
      case ARCING -> arc(1, p.arcSpeedMaxMmPerS());
      case GOAL -> arrive();
      default -> throw new IllegalStateException("no command in state " + state);
    };
  }

  private WheelCommand arrive() {
    status = MotionFlag.DONE;
    return p.stopAtDestination() ? WheelCommand.STOP : last;
  }

  private MotionState next() {
    double off = Math.abs(bearingRad);
    if (turnOnly) {
      return off <= p.smallTurnAngleRad() ? MotionState.GOAL : MotionState.TURN;
    }
    if (distanceMm <= p.goalRadiusMm()) {
      return MotionState.GOAL;
    }
    return switch (state) {
      case INIT ->
          p.enableArcing() && distanceMm <= p.arcRadiusMm() && off <= p.arcAngleMaxRad()
              ? MotionState.ARCING
              : turnOrStraight(off);
      case TURN -> turnOrStraight(off);
      case ARCING -> {
        if (off > p.arcExitAngleRad()) {
          yield MotionState.TURN;
        }
        yield off < p.straightAngleRad() ? MotionState.STRAIGHT : MotionState.ARCING;
      }
      case STRAIGHT, SMALLTURN -> {
        if (off > p.arcAngleMaxRad()) {
          yield MotionState.TURN;
        }
        yield off < p.smallTurnAngleRad() ? MotionState.STRAIGHT : MotionState.SMALLTURN;
      }
      default -> throw new IllegalStateException("no way on from state " + state);
    };
  }

  private MotionState turnOrStraight(double off) {
    return off <= p.smallTurnAngleRad() ? MotionState.STRAIGHT : MotionState.TURN;
  }

  /** From the maximum speed far from the wanted heading to the minimum at it, never past it. */
  private double turnSpeed() {
    double off = Math.abs(bearingRad);
    double speed =
        ramp(
            off,
            p.smallTurnAngleRad(),
            p.slowTurnAngleRad(),
            p.turnSpeedMinRadPerS(),
            p.turnSpeedMaxRadPerS());
    return StrictMath.copySign(Math.min(speed, off / p.reachS()), bearingRad);
  }

  /** From the maximum speed far from the target to the minimum at it, never past it. */
  private double forwardSpeed(double maxMmPerS) {
    double speed =
        ramp(
            distanceMm,
            p.goalRadiusMm(),
            p.slowFwdRadiusMm(),
            p.linSpeedMinMmPerS(),
            p.linSpeedMaxMmPerS());
    return Math.min(Math.min(speed, maxMmPerS), distanceMm / p.reachS());
  }

  /** Drives on a circle of {@code part} times the radius of the circle that leads to the target. */
  private WheelCommand arc(double part, double maxMmPerS) {
    double speed = forwardSpeed(maxMmPerS);
    double turn = speed * 2 * Sines.sin(bearingRad) / (distanceMm * part);
    double most = Math.min(p.turnSpeedMaxRadPerS(), 2 * Math.abs(bearingRad) / p.reachS());
    return new WheelCommand(speed, Math.max(-most, Math.min(most, turn)));
  }

  private static double ramp(double at, double low, double high, double slow, double fast) {
    if (at >= high) {
      return fast;
    }
    return at <= low ? slow : slow + (fast - slow) * (at - low) / (high - low);
  }
}
