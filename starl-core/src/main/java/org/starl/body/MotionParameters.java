package org.starl.body;

import org.starl.geometry.Angles;

/**
 * Motion parameters of a robot. Names are the original StarL's plus units; its degrees are radians
 * here. The defaults down to {@code collisionTurnMs} are the original's. Immutable; see {@link
 * #builder}.
 *
 * @param style the motion automaton
 * @param turnSpeedMaxRadPerS turning speed far from the wanted heading (110 degrees/s)
 * @param turnSpeedMinRadPerS turning speed at the wanted heading (25 degrees/s)
 * @param linSpeedMaxMmPerS forward speed far from the target
 * @param linSpeedMinMmPerS forward speed at the goal radius
 * @param goalRadiusMm the target is reached within this distance
 * @param slowFwdRadiusMm slows down within this distance of the target
 * @param smallTurnAngleRad tolerance of the heading (3 degrees)
 * @param slowTurnAngleRad turns more slowly below this heading error (25 degrees)
 * @param straightAngleRad an arc becomes a straight line below this angle (6 degrees)
 * @param arcExitAngleRad an arc is abandoned above this angle (30 degrees)
 * @param arcRadiusMm maximum distance at which an arc may begin
 * @param arcAngleMaxRad maximum angle at which an arc may begin (25 degrees)
 * @param arcSpeedMaxMmPerS forward speed on an arc
 * @param enableArcing whether a motion may begin with an arc
 * @param stopAtDestination whether the wheels stop at the target; otherwise the robot drives on
 * @param robotRadiusMm radius of the body, a disc
 * @param automatonPeriodMs time between steps
 * @param collisionPolicy reaction of a GOAL robot to a bump
 * @param robotType see {@link RobotType}
 * @param collisionStraightMs time of driving straight after a collision
 * @param collisionBackMs time of backing off after a collision
 * @param collisionTurnMs minimum time of turning away after a collision
 * @param speedError the body drives and turns between 0 (blocked) and 1 + speedError times the
 *     commanded speed, independently of each other; includes the drift of the robot's clock
 * @param reactionMs a step's command is in effect, braking included, within this time after the
 *     step was due; includes the delay of the step, the transmission to the wheels and braking
 * @param maxFixAgeMs an older fix stops the wheels until a newer one arrives
 * @param maxErrorMm a larger position error bound stops the wheels until a fix improves it
 * @param failFixAgeMs the motion fails after this time without a fix or a position that is certain
 *     enough
 * @param stuckAfterMs the motion fails if the wheels turn for this time but the robot does not move
 * @param noProgressMs the motion fails after this time without coming nearer to the target
 * @param slowestMmPerS the motion fails if its average speed is lower; see {@link #longestMs}
 * @param avoidPatienceMs the motion fails if the region to avoid blocks it for this time
 * @param contactMarkMm side of the square that a contact adds to the map
 */
public record MotionParameters(
    MotionStyle style,
    double turnSpeedMaxRadPerS,
    double turnSpeedMinRadPerS,
    double linSpeedMaxMmPerS,
    double linSpeedMinMmPerS,
    double goalRadiusMm,
    double slowFwdRadiusMm,
    double smallTurnAngleRad,
    double slowTurnAngleRad,
    double straightAngleRad,
    double arcExitAngleRad,
    double arcRadiusMm,
    double arcAngleMaxRad,
    double arcSpeedMaxMmPerS,
    boolean enableArcing,
    boolean stopAtDestination,
    double robotRadiusMm,
    long automatonPeriodMs,
    CollisionPolicy collisionPolicy,
    RobotType robotType,
    long collisionStraightMs,
    long collisionBackMs,
    long collisionTurnMs,
    double speedError,
    long reactionMs,
    long maxFixAgeMs,
    double maxErrorMm,
    long failFixAgeMs,
    long stuckAfterMs,
    long noProgressMs,
    double slowestMmPerS,
    long avoidPatienceMs,
    double contactMarkMm) {

  public static final MotionParameters DEFAULT = builder().build();

  public MotionParameters {
    MotionLimits.positive("turnSpeedMinRadPerS", turnSpeedMinRadPerS);
    MotionLimits.ordered("turn speeds", turnSpeedMinRadPerS, turnSpeedMaxRadPerS);
    MotionLimits.positive("linSpeedMinMmPerS", linSpeedMinMmPerS);
    MotionLimits.ordered("forward speeds", linSpeedMinMmPerS, linSpeedMaxMmPerS);
    MotionLimits.positive("arcSpeedMaxMmPerS", arcSpeedMaxMmPerS);
    MotionLimits.positive("goalRadiusMm", goalRadiusMm);
    MotionLimits.notNegative("slowFwdRadiusMm", slowFwdRadiusMm);
    MotionLimits.notNegative("arcRadiusMm", arcRadiusMm);
    MotionLimits.positive("smallTurnAngleRad", smallTurnAngleRad);
    MotionLimits.ordered("turn angles", smallTurnAngleRad, slowTurnAngleRad);
    MotionLimits.ordered("smallTurnAngleRad and arcAngleMaxRad", smallTurnAngleRad, arcAngleMaxRad);
    MotionLimits.ordered("straight and arc exit angles", straightAngleRad, arcExitAngleRad);
    MotionLimits.positive("straightAngleRad", straightAngleRad);
    MotionLimits.below("arcAngleMaxRad", arcAngleMaxRad, StrictMath.PI / 2);
    MotionLimits.below("arcExitAngleRad", arcExitAngleRad, StrictMath.PI / 2);
    MotionLimits.positive("robotRadiusMm", robotRadiusMm);
    MotionLimits.positive("automatonPeriodMs", automatonPeriodMs);
    MotionLimits.notNegative("collisionStraightMs", collisionStraightMs);
    MotionLimits.notNegative("collisionBackMs", collisionBackMs);
    MotionLimits.notNegative("collisionTurnMs", collisionTurnMs);
    MotionLimits.notNegative("speedError", speedError);
    MotionLimits.below("speedError", speedError, 1);
    MotionLimits.notNegative("reactionMs", reactionMs);
    MotionLimits.positive("maxFixAgeMs", maxFixAgeMs);
    MotionLimits.positive("maxErrorMm", maxErrorMm);
    MotionLimits.ordered("fix ages", maxFixAgeMs, failFixAgeMs);
    MotionLimits.positive("stuckAfterMs", stuckAfterMs);
    MotionLimits.positive("noProgressMs", noProgressMs);
    MotionLimits.positive("slowestMmPerS", slowestMmPerS);
    MotionLimits.notNegative("avoidPatienceMs", avoidPatienceMs);
    MotionLimits.positive("contactMarkMm", contactMarkMm);
  }

  /** A builder that starts with the defaults. */
  public static Builder builder() {
    return new Builder();
  }

  /** A builder that starts with these parameters. */
  public Builder toBuilder() {
    return new Builder(this);
  }

  /** The reaction to a bump: {@link RobotType}s other than GOAL react alike under every policy. */
  public CollisionPolicy reaction() {
    return robotType == RobotType.GOAL ? collisionPolicy : CollisionPolicy.USE_COLBACK;
  }

  /** Time limit of a motion over this distance: DONE or FAIL after at most this time. */
  public long longestMs(double distanceMm) {
    return failFixAgeMs + noProgressMs + (long) StrictMath.ceil(1e3 * distanceMm / slowestMmPerS);
  }

  /** A corner of a planned way is passed within this distance. */
  public double cornerRadiusMm() {
    return goalRadiusMm / 3;
  }

  /** How long a step's command may be in effect. */
  public double horizonS() {
    return (automatonPeriodMs + reactionMs) / 1e3;
  }

  /** Maximum effect of one step's command, in seconds at the commanded speed. */
  public double reachS() {
    return (1 + speedError) * horizonS();
  }

  /** Collects parameters. {@link #build} checks them. */
  public static final class Builder {
    private MotionStyle style = MotionStyle.UNICYCLE;
    private double turnSpeedMaxRadPerS = Angles.fromDegrees(110);
    private double turnSpeedMinRadPerS = Angles.fromDegrees(25);
    private double linSpeedMaxMmPerS = 250;
    private double linSpeedMinMmPerS = 175;
    private double goalRadiusMm = 75;
    private double slowFwdRadiusMm = 700;
    private double smallTurnAngleRad = Angles.fromDegrees(3);
    private double slowTurnAngleRad = Angles.fromDegrees(25);
    private double straightAngleRad = Angles.fromDegrees(6);
    private double arcExitAngleRad = Angles.fromDegrees(30);
    private double arcRadiusMm = 700;
    private double arcAngleMaxRad = Angles.fromDegrees(25);
    private double arcSpeedMaxMmPerS = 200;
    private boolean enableArcing = true;
    private boolean stopAtDestination = true;
    private double robotRadiusMm = 165;
    private long automatonPeriodMs = 60;
    private CollisionPolicy collisionPolicy = CollisionPolicy.STOP_ON_COLLISION;
    private RobotType robotType = RobotType.GOAL;
    private long collisionStraightMs = 1250;
    private long collisionBackMs = 800;
    private long collisionTurnMs = 500;
    private double speedError = 0;
    private long reactionMs = 0;
    private long maxFixAgeMs = 300;
    private double maxErrorMm = 500;
    private long failFixAgeMs = 2000;
    private long stuckAfterMs = 5000;
    private long noProgressMs = 20000;
    private double slowestMmPerS = 25;
    private long avoidPatienceMs = 300;
    private double contactMarkMm = 1;

    private Builder() {}

    private Builder(MotionParameters p) {
      style = p.style;
      turnSpeedMaxRadPerS = p.turnSpeedMaxRadPerS;
      turnSpeedMinRadPerS = p.turnSpeedMinRadPerS;
      linSpeedMaxMmPerS = p.linSpeedMaxMmPerS;
      linSpeedMinMmPerS = p.linSpeedMinMmPerS;
      goalRadiusMm = p.goalRadiusMm;
      slowFwdRadiusMm = p.slowFwdRadiusMm;
      smallTurnAngleRad = p.smallTurnAngleRad;
      slowTurnAngleRad = p.slowTurnAngleRad;
      straightAngleRad = p.straightAngleRad;
      arcExitAngleRad = p.arcExitAngleRad;
      arcRadiusMm = p.arcRadiusMm;
      arcAngleMaxRad = p.arcAngleMaxRad;
      arcSpeedMaxMmPerS = p.arcSpeedMaxMmPerS;
      enableArcing = p.enableArcing;
      stopAtDestination = p.stopAtDestination;
      robotRadiusMm = p.robotRadiusMm;
      automatonPeriodMs = p.automatonPeriodMs;
      collisionPolicy = p.collisionPolicy;
      robotType = p.robotType;
      collisionStraightMs = p.collisionStraightMs;
      collisionBackMs = p.collisionBackMs;
      collisionTurnMs = p.collisionTurnMs;
      speedError = p.speedError;
      reactionMs = p.reactionMs;
      maxFixAgeMs = p.maxFixAgeMs;
      maxErrorMm = p.maxErrorMm;
      failFixAgeMs = p.failFixAgeMs;
      stuckAfterMs = p.stuckAfterMs;
      noProgressMs = p.noProgressMs;
      slowestMmPerS = p.slowestMmPerS;
      avoidPatienceMs = p.avoidPatienceMs;
      contactMarkMm = p.contactMarkMm;
    }

    public Builder style(MotionStyle value) {
      style = value;
      return this;
    }

    public Builder turnSpeedMaxRadPerS(double value) {
      turnSpeedMaxRadPerS = value;
      return this;
    }

    public Builder turnSpeedMinRadPerS(double value) {
      turnSpeedMinRadPerS = value;
      return this;
    }

    public Builder linSpeedMaxMmPerS(double value) {
      linSpeedMaxMmPerS = value;
      return this;
    }

    public Builder linSpeedMinMmPerS(double value) {
      linSpeedMinMmPerS = value;
      return this;
    }

    /** Straight on at the greatest forward speed, without slowing down before the target. */
    public Builder constantSpeed() {
      return linSpeedMinMmPerS(linSpeedMaxMmPerS);
    }

    public Builder goalRadiusMm(double value) {
      goalRadiusMm = value;
      return this;
    }

    public Builder slowFwdRadiusMm(double value) {
      slowFwdRadiusMm = value;
      return this;
    }

    public Builder smallTurnAngleRad(double value) {
      smallTurnAngleRad = value;
      return this;
    }

    public Builder slowTurnAngleRad(double value) {
      slowTurnAngleRad = value;
      return this;
    }

    public Builder straightAngleRad(double value) {
      straightAngleRad = value;
      return this;
    }

    public Builder arcExitAngleRad(double value) {
      arcExitAngleRad = value;
      return this;
    }

    public Builder arcRadiusMm(double value) {
      arcRadiusMm = value;
      return this;
    }

    public Builder arcAngleMaxRad(double value) {
      arcAngleMaxRad = value;
      return this;
    }

    public Builder arcSpeedMaxMmPerS(double value) {
      arcSpeedMaxMmPerS = value;
      return this;
    }

    public Builder enableArcing(boolean value) {
      enableArcing = value;
      return this;
    }

    public Builder stopAtDestination(boolean value) {
      stopAtDestination = value;
      return this;
    }

    public Builder robotRadiusMm(double value) {
      robotRadiusMm = value;
      return this;
    }

    public Builder automatonPeriodMs(long value) {
      automatonPeriodMs = value;
      return this;
    }

    public Builder collisionPolicy(CollisionPolicy value) {
      collisionPolicy = value;
      return this;
    }

    public Builder robotType(RobotType value) {
      robotType = value;
      return this;
    }

    public Builder collisionStraightMs(long value) {
      collisionStraightMs = value;
      return this;
    }

    public Builder collisionBackMs(long value) {
      collisionBackMs = value;
      return this;
    }

    public Builder collisionTurnMs(long value) {
      collisionTurnMs = value;
      return this;
    }

    public Builder speedError(double value) {
      speedError = value;
      return this;
    }

    public Builder reactionMs(long value) {
      reactionMs = value;
      return this;
    }

    public Builder maxFixAgeMs(long value) {
      maxFixAgeMs = value;
      return this;
    }

    public Builder maxErrorMm(double value) {
      maxErrorMm = value;
      return this;
    }

    public Builder failFixAgeMs(long value) {
      failFixAgeMs = value;
      return this;
    }

    public Builder stuckAfterMs(long value) {
      stuckAfterMs = value;
      return this;
    }

    public Builder noProgressMs(long value) {
      noProgressMs = value;
      return this;
    }

    public Builder slowestMmPerS(double value) {
      slowestMmPerS = value;
      return this;
    }

    public Builder avoidPatienceMs(long value) {
      avoidPatienceMs = value;
      return this;
    }

    public Builder contactMarkMm(double value) {
      contactMarkMm = value;
      return this;
    }

    /**
     * Checks the parameters.
     *
     * @throws IllegalArgumentException if one is out of range
     */
    public MotionParameters build() {
      return new MotionParameters(
          style,
          turnSpeedMaxRadPerS,
          turnSpeedMinRadPerS,
          linSpeedMaxMmPerS,
          linSpeedMinMmPerS,
          goalRadiusMm,
          slowFwdRadiusMm,
          smallTurnAngleRad,
          slowTurnAngleRad,
          straightAngleRad,
          arcExitAngleRad,
          arcRadiusMm,
          arcAngleMaxRad,
          arcSpeedMaxMmPerS,
          enableArcing,
          stopAtDestination,
          robotRadiusMm,
          automatonPeriodMs,
          collisionPolicy,
          robotType,
          collisionStraightMs,
          collisionBackMs,
          collisionTurnMs,
          speedError,
          reactionMs,
          maxFixAgeMs,
          maxErrorMm,
          failFixAgeMs,
          stuckAfterMs,
          noProgressMs,
          slowestMmPerS,
          avoidPatienceMs,
          contactMarkMm);
    }
  }
}
