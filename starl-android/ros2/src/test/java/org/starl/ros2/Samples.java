package org.starl.ros2;

import java.util.HexFormat;

/**
 * Messages as rclpy of ROS 2 Jazzy serializes them (padding, which it leaves undefined, is zero here). Stamp: 7 s
 * and 5 ns. Pose: (1.5 m, -0.25 m), 1 rad, in the frame map, for odometry odom. Speeds: 0.2 m/s, -0.5 rad/s.
 * Variances: 0.0004 and 0.0001 m^2, 0.01 rad^2. Laser: the second beam from the left is 0.15 m long.
 */
final class Samples {

  static final byte[] ODOMETRY =
      bytes(
          "000100000700000005000000050000006f646f6d007f00000a000000626173655f6c696e6b000000"
              + "b0997859000000000000f83f000000000000d0bf"
              + "00".repeat(24)
              + "f0054b74e8aede3f507d5b062815ec3f"
              + "00".repeat(288)
              + "9a9999999999c93f"
              + "00".repeat(38)
              + "e0bf"
              + "00".repeat(288));

  static final byte[] POSE_WITH_COVARIANCE =
      bytes(
          "000100000700000005000000040000006d617000000000000000f83f000000000000d0bf"
              + "00".repeat(24)
              + "f0054b74e8aede3f507d5b062815ec3f2d431cebe2363a3f"
              + "00".repeat(48)
              + "2d431cebe2361a3f"
              + "00".repeat(216)
              + "7b14ae47e17a843f");

  static final byte[] POSE =
      bytes(
          "000100000700000005000000040000006d617000000000000000f83f000000000000d0bf"
              + "00".repeat(24)
              + "f0054b74e8aede3f507d5b062815ec3f");

  static final byte[] SCAN =
      bytes(
          "0001"
              + "00".repeat(10)
              + "060000006c61736572000000000080bf0000803f0000003f0000000000000000cdcc4c3d0000a040"
              + "050000000000804000008040000080409a99193e0000807f00000000");

  static final byte[] TWIST = bytes("000100009a9999999999c93f" + "00".repeat(38) + "e0bf");

  static final byte[] TWIST_STAMPED =
      bytes(
          "0001000007000000050000000a000000626173655f6c696e6b0000009a9999999999c93f"
              + "00".repeat(38)
              + "e0bf");

  private Samples() {}

  private static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex);
  }
}
