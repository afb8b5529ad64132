package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.BufferUnderflowException;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/** Messages against the bytes of rclpy, and any bytes. */
class MessagesTest {

  private static final WheelCommand SPEEDS = new WheelCommand(200, -0.5);

  @Test
  void speedsAreWrittenAsRclpyDoes() {
    assertThat(Messages.twist(SPEEDS, RosType.TWIST, 7_000_000_005L).bytes())
        .isEqualTo(Samples.TWIST);
    assertThat(Messages.twist(SPEEDS, RosType.TWIST_STAMPED, 7_000_000_005L).bytes())
        .isEqualTo(Samples.TWIST_STAMPED);
  }

  @Test
  void odometryIsReadAsRclpyWritesIt() {
    Messages.Odometry odometry = Messages.odometry(Cdr.of(Samples.ODOMETRY));
    assertThat(odometry)
        .isEqualTo(new Messages.Odometry(7_000_000_005L, odometry.pose(), 200, -0.5));
    assertThat(odometry.pose().xMm()).isEqualTo(1500);
  }

  @Test
  void posesAreReadInMillimetres() {
    for (RosType type : List.of(RosType.POSE_STAMPED, RosType.ODOMETRY)) {
      Messages.Measured measured =
          Messages.measured(
              Cdr.of(type == RosType.ODOMETRY ? Samples.ODOMETRY : Samples.POSE), type);
      assertThat(measured.stampNs()).isEqualTo(7_000_000_005L);
      assertThat(measured.frame()).isEqualTo(type == RosType.ODOMETRY ? "odom" : "map");
      assertThat(measured.sigmaMm()).isZero();
      assertThat(measured.pose()).isNotNull();
      assertThat(measured.pose().xMm()).isEqualTo(1500);
      assertThat(measured.pose().yMm()).isEqualTo(-250);
      assertThat(measured.pose().headingRad()).isCloseTo(1, within(1e-12));
    }
  }

  @Test
  void theLargerVarianceBoundsThePosition() {
    Messages.Measured measured =
        Messages.measured(
            Cdr.of(Samples.POSE_WITH_COVARIANCE), RosType.POSE_WITH_COVARIANCE_STAMPED);
    assertThat(measured.sigmaMm()).isCloseTo(20, within(1e-9));
    assertThat(measured.sigmaRad()).isCloseTo(0.1, within(1e-12));
  }

  @Property
  void noDirectionHasALargerDeviationThanTheBound(
      @ForAll @IntRange(max = 1000) int a,
      @ForAll @IntRange(max = 1000) int b,
      @ForAll @IntRange(min = -1000, max = 1000) int c,
      @ForAll @IntRange(max = 359) int degrees) {
    // A covariance L L^T of L = (a 0; c b), and its variance along one direction.
    double x = StrictMath.cos(StrictMath.toRadians(degrees));
    double y = StrictMath.sin(StrictMath.toRadians(degrees));
    double along = a * x + c * y;
    double variance = along * along + b * b * y * y;
    Messages.Measured measured =
        measuredWith((double) a * a, (double) a * c, (double) c * c + (double) b * b);
    assertThat(measured.sigmaMm() / 1000)
        .isGreaterThanOrEqualTo(StrictMath.sqrt(variance) - 1e-6 * (1 + Math.abs(along)));
  }

  @Test
  void impossiblePosesAreNone() {
    assertThat(measuredWith(Double.NaN, 0, 0).pose()).isNull();
    assertThat(measuredWith(-1, 0, 0).pose()).isNull();
    assertThat(measuredWith(1, 0, Double.POSITIVE_INFINITY).pose()).isNull();
    Cdr still = Cdr.empty().header(1, "map").f64(1, 1, 0, 0, 0, 0, 0);
    assertThat(Messages.measured(Cdr.of(still.bytes()), RosType.POSE_STAMPED).pose()).isNull();
  }

  @Test
  void aNearRangeOnOneSideIsAContactThere() {
    assertThat(Messages.contacts(Cdr.of(Samples.SCAN), RosType.LASER_SCAN, 200))
        .isEqualTo(Contacts.of(true, false, false, false));
    assertThat(Messages.contacts(Cdr.of(Samples.SCAN), RosType.LASER_SCAN, 149))
        .isEqualTo(Contacts.NONE);
  }

  @Test
  void hazardsOfACreate3() {
    Cdr out = Cdr.empty().header(1, "base_link").i32(4);
    for (Object[] hazard :
        new Object[][] {
          {"bump_front_left", 1}, {"cliff_side_left", 2}, {"wheel_drop_right", 4}, {"", 5}
        }) {
      out.header(1, (String) hazard[0]).u8((int) hazard[1]);
    }
    assertThat(contacts(out)).isEqualTo(new Contacts(Bumps.LEFT, true, true));
    assertThat(contacts(Cdr.empty().header(1, "base_link").i32(0))).isEqualTo(Contacts.NONE);
    Cdr middle = Cdr.empty().header(1, "").i32(1).header(1, "bump_front_center").u8(1);
    assertThat(contacts(middle)).isEqualTo(new Contacts(Bumps.BOTH, false, false));
  }

  /** A reader of outside bytes fails in one way only, and makes nothing larger than they are. */
  @Property
  void anyBytesAreReadOrCutOff(
      @ForAll byte[] noise, @ForAll @IntRange(max = 800) int length, @ForAll int seed) {
    for (byte[] whole : List.of(Samples.ODOMETRY, Samples.POSE, Samples.SCAN, noise)) {
      byte[] bytes = Arrays.copyOf(whole, Math.min(length, whole.length));
      if (bytes.length > 4 && seed % 3 != 0) {
        bytes[Math.floorMod(seed, bytes.length)] = (byte) seed;
      }
      for (RosType type : RosType.values()) {
        try {
          switch (type) {
            case ODOMETRY -> {
              Messages.odometry(Cdr.of(bytes));
              Messages.measured(Cdr.of(bytes), type);
            }
            case POSE_STAMPED, POSE_WITH_COVARIANCE_STAMPED ->
                Messages.measured(Cdr.of(bytes), type);
            case BOOL, LASER_SCAN, HAZARD_DETECTION_VECTOR ->
                Messages.contacts(Cdr.of(bytes), type, 200);
            default -> {}
          }
        } catch (BufferUnderflowException cutOff) {
          assertThat(bytes.length).isLessThan(1000);
        }
      }
    }
  }

  private static Contacts contacts(Cdr message) {
    return Messages.contacts(Cdr.of(message.bytes()), RosType.HAZARD_DETECTION_VECTOR, 200);
  }

  private static Messages.Measured measuredWith(double xx, double xy, double yy) {
    double[] covariance = new double[36];
    covariance[0] = xx;
    covariance[1] = xy;
    covariance[6] = xy;
    covariance[7] = yy;
    Cdr out = Cdr.empty().header(1, "map").f64(1, 1, 0, 0, 0, 0, 1).f64(covariance);
    return Messages.measured(Cdr.of(out.bytes()), RosType.POSE_WITH_COVARIANCE_STAMPED);
  }
}
