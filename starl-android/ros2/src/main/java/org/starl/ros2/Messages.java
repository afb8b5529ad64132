package org.starl.ros2;

import java.util.Arrays;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/** The messages of a base and of a measuring system, to and from bytes. Pure. */
final class Messages {

  private static final double MM_PER_M = 1000;
  private static final long NS_PER_S = 1_000_000_000L;
  private static final double UNIT_ERROR = 0.01;
  private static final int SIX = 6;

  private Messages() {}

  /**
   * A base's odometry.
   *
   * @param stampNs time on the base's clock; 0 if it has none
   * @param pose in a frame of its own, which may drift; null: impossible numbers
   * @param linearMmPerS speed in the base's frame
   */
  record Odometry(long stampNs, @Nullable Pose pose, double linearMmPerS, double angularRadPerS) {}

  /**
   * A pose.
   *
   * @param stampNs time on its sender's clock; 0 if it has none
   * @param frame without a leading slash
   * @param pose null: its numbers are impossible for a robot on a floor
   * @param sigmaMm largest standard deviation of the position, in any direction; 0 if not given
   * @param sigmaRad likewise of the heading
   */
  record Measured(
      long stampNs, String frame, @Nullable Pose pose, double sigmaMm, double sigmaRad) {}

  /** A Twist; with a stamp and the frame base_link a TwistStamped. */
  static Cdr twist(WheelCommand command, RosType type, long unixNs) {
    Cdr out = Cdr.empty();
    if (type == RosType.TWIST_STAMPED) {
      out.header(unixNs, "base_link");
    }
    return out.f64(command.linearMmPerS() / MM_PER_M, 0, 0, 0, 0, command.angularRadPerS());
  }

  /** A nav_msgs/Odometry; null if its speeds are not finite. */
  static @Nullable Odometry odometry(Cdr in) {
    Measured measured = measured(in, RosType.ODOMETRY);
    double x = in.f64();
    skip(in, 4);
    double turn = in.f64();
    return Double.isFinite(x) && Double.isFinite(turn)
        ? new Odometry(measured.stampNs, measured.pose, x * MM_PER_M, turn)
        : null;
  }

  /** The pose of a message of one of the three types of poses. */
  static Measured measured(Cdr in, RosType type) {
    Header header = header(in);
    if (type == RosType.ODOMETRY) {
      in.text();
    }
    double x = in.f64();
    double y = in.f64();
    in.f64();
    double[] q = {in.f64(), in.f64(), in.f64(), in.f64()};
    double sigmaM = 0;
    double sigmaRad = 0;
    if (type != RosType.POSE_STAMPED) {
      double[] covariance = new double[SIX * SIX];
      Arrays.setAll(covariance, i -> in.f64());
      sigmaM = sigma(covariance[0], covariance[1], covariance[SIX], covariance[SIX + 1]);
      sigmaRad = StrictMath.sqrt(covariance[SIX * SIX - 1]);
    }
    double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    boolean isPossible =
        Double.isFinite(x)
            && Double.isFinite(y)
            && Double.isFinite(sigmaM)
            && Double.isFinite(sigmaRad)
            && Math.abs(norm - 1) <= UNIT_ERROR;
    double heading =
        StrictMath.atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2]));
    return new Measured(
        header.stampNs,
        header.frame,
        isPossible ? new Pose(x * MM_PER_M, y * MM_PER_M, Angles.normalize(heading)) : null,
        sigmaM * MM_PER_M,
        sigmaRad);
  }

  /** A std_msgs/Bool. */
  static Contacts contacts(Cdr in, RosType type, double nearMm) {
    return switch (type) {
      case BOOL -> in.u8() == 0 ? Contacts.NONE : Contacts.of(true, true, false, false);
      case LASER_SCAN -> scan(in, nearMm);
      case HAZARD_DETECTION_VECTOR -> hazards(in);
      default -> throw new IllegalArgumentException(type + " has no contacts");
    };
  }

  /** The largest standard deviation of two coordinates: of the larger eigenvalue; NaN if negative. */
  private static double sigma(double xx, double xy, double yx, double yy) {
    double mixed = (xy + yx) / 2;
    double half = (xx - yy) / 2;
    double root = StrictMath.sqrt(half * half + mixed * mixed);
    return xx < 0 || yy < 0 ? Double.NaN : StrictMath.sqrt((xx + yy) / 2 + root);
  }

  /** The nearest range on each side of the front half of a laser that looks forward. */
  private static Contacts scan(Cdr in, double nearMm) {
    header(in);
    double angle = in.f32();
    in.f32();
    double step = in.f32();
    in.f32();
    in.f32();
    double least = in.f32();
    in.f32();
    boolean left = false;
    boolean right = false;
    for (int left0 = in.count(4); left0 > 0; left0--) {
      double range = in.f32();
      double bearing = Angles.normalize(angle);
      boolean isNear = range >= least && range * MM_PER_M < nearMm;
      left |= isNear && bearing >= 0 && bearing <= StrictMath.PI / 2;
      right |= isNear && bearing <= 0 && bearing >= -StrictMath.PI / 2;
      angle += step;
    }
    return Contacts.of(left, right, false, false);
  }

  /** A HazardDetection has a header, whose frame names the sensor, and a type. */
  private static Contacts hazards(Cdr in) {
    header(in);
    boolean left = false;
    boolean right = false;
    boolean isCliff = false;
    boolean isDropped = false;
    for (int more = in.count(13); more > 0; more--) {
      String sensor = header(in).frame.toLowerCase(Locale.ROOT);
      switch (in.u8()) {
        case 1 -> {
          left |= !sensor.contains("right");
          right |= !sensor.contains("left");
        }
        case 2 -> isCliff = true;
        case 3 -> {
          left = true;
          right = true;
        }
        case 4 -> isDropped = true;
        default -> {
          // 0 backs into its own safety limit, 5 is near: the base handles the first itself
        }
      }
    }
    return Contacts.of(left, right, isCliff, isDropped);
  }

  private record Header(long stampNs, String frame) {}

  private static Header header(Cdr in) {
    int seconds = in.i32();
    int nanos = in.i32();
    String frame = in.text();
    return new Header(
        seconds * NS_PER_S + (nanos & 0xFFFF_FFFFL),
        frame.startsWith("/") ? frame.substring(1) : frame);
  }

  private static void skip(Cdr in, int numbers) {
    for (int i = 0; i < numbers; i++) {
      in.f64();
    }
  }
}
