package org.starl.robot.create;

import org.starl.time.Time;

/** The wheels of a simulated Create: last command, speeds and odometry. */
final class CreateWheels {

  private static final int MAX_RADIUS_MM = 2000;
  private static final int MAX_PWM = 255;

  /** Radius of the robot: on a narrower backward curve, too, it may reach a cliff. */
  private static final double BODY_RADIUS_MM = 170;

  private final CreateModel model;
  private int velocity;
  private int radius;
  private int right;
  private int left;
  private double leftMmPerS;
  private double rightMmPerS;

  private long turnedUntilNs;
  private double leftMm;
  private double rightMm;
  private double unreadMm;
  private double unreadDegrees;

  CreateWheels(CreateModel model) {
    this.model = model;
  }

  double leftMmPerS() {
    return leftMmPerS;
  }

  double rightMmPerS() {
    return rightMmPerS;
  }

  /** Drives on a circle: opcode 137. */
  void drive(int mmPerS, int radiusMm) {
    velocity = clamp(mmPerS, CreateModel.MAX_WHEEL_MM_PER_S);
    radius = radiusMm;
    if (radiusMm == Opcodes.STRAIGHT || radiusMm == Opcodes.STRAIGHT_TOO || radiusMm == 0) {
      turn(velocity, velocity);
    } else if (radiusMm == Opcodes.SPIN_LEFT || radiusMm == Opcodes.SPIN_RIGHT) {
      turn(-velocity * radiusMm, velocity * radiusMm);
    } else {
      radius = clamp(radiusMm, MAX_RADIUS_MM);
      double fraction = model.axleMm() / 2 / radius;
      turn(velocity * (1 - fraction), velocity * (1 + fraction));
    }
  }

  /** Sets the speed of each wheel: opcode 145. */
  void driveDirect(int rightWheel, int leftWheel) {
    right = clamp(rightWheel, CreateModel.MAX_WHEEL_MM_PER_S);
    left = clamp(leftWheel, CreateModel.MAX_WHEEL_MM_PER_S);
    turn(left, right);
  }

  /** Opcode 146: fractions of the motors' power, here of their speed. */
  void drivePwm(int rightWheel, int leftWheel) {
    double mmPerS = (double) CreateModel.MAX_WHEEL_MM_PER_S / MAX_PWM;
    turn(clamp(leftWheel, MAX_PWM) * mmPerS, clamp(rightWheel, MAX_PWM) * mmPerS);
  }

  void stop() {
    turn(0, 0);
  }

  /** Whether it drives forward, or backward on a curve narrower than the robot. */
  boolean mayCrossACliff() {
    double sum = leftMmPerS + rightMmPerS;
    double difference = Math.abs(rightMmPerS - leftMmPerS);
    return sum > 0 || (sum < 0 && -sum / 2 * model.axleMm() < BODY_RADIUS_MM * difference);
  }

  void turnUntil(long atNs) {
    double seconds = Time.seconds(Math.max(0, atNs - turnedUntilNs));
    turnedUntilNs = Math.max(atNs, turnedUntilNs);
    leftMm += leftMmPerS * seconds;
    rightMm += rightMmPerS * seconds;
    unreadMm += (leftMmPerS + rightMmPerS) / 2 * seconds;
    unreadDegrees += (rightMmPerS - leftMmPerS) * seconds / model.axleMm() * 180 / StrictMath.PI;
  }

  /** The value of a packet about the wheels; 0 for any other. Reading distance or angle resets it. */
  int value(int packet) {
    return switch (packet) {
      case Packets.DISTANCE -> {
        int mm = clamp((int) unreadMm, Short.MAX_VALUE);
        unreadMm = Math.abs(unreadMm) > Short.MAX_VALUE ? 0 : unreadMm - mm;
        yield mm;
      }
      case Packets.ANGLE -> {
        int degrees = clamp((int) unreadDegrees, Short.MAX_VALUE);
        unreadDegrees = Math.abs(unreadDegrees) > Short.MAX_VALUE ? 0 : unreadDegrees - degrees;
        yield degrees;
      }
      case Packets.VELOCITY -> velocity;
      case Packets.RADIUS -> radius;
      case Packets.RIGHT_VELOCITY -> right;
      case Packets.LEFT_VELOCITY -> left;
      case Packets.LEFT_ENCODER -> counts(leftMm);
      case Packets.RIGHT_ENCODER -> counts(rightMm);
      default -> 0;
    };
  }

  private void turn(double newLeftMmPerS, double newRightMmPerS) {
    leftMmPerS = clamp(newLeftMmPerS);
    rightMmPerS = clamp(newRightMmPerS);
  }

  private static int counts(double mm) {
    return (int) (long) StrictMath.floor(mm / CreateModel.countMm());
  }

  private static double clamp(double mmPerS) {
    return Math.max(
        -CreateModel.MAX_WHEEL_MM_PER_S, Math.min(mmPerS, CreateModel.MAX_WHEEL_MM_PER_S));
  }

  private static int clamp(int value, int most) {
    return Math.max(-most, Math.min(value, most));
  }
}
