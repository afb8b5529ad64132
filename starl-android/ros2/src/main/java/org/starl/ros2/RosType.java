package org.starl.ros2;

/** The messages' types that StarL uses. */
enum RosType {
  TWIST("geometry_msgs", "Twist", 256),
  TWIST_STAMPED("geometry_msgs", "TwistStamped", 1024),
  POSE_STAMPED("geometry_msgs", "PoseStamped", 2048),
  POSE_WITH_COVARIANCE_STAMPED("geometry_msgs", "PoseWithCovarianceStamped", 2048),
  ODOMETRY("nav_msgs", "Odometry", 4096),
  BOOL("std_msgs", "Bool", 64),
  LASER_SCAN("sensor_msgs", "LaserScan", 65_536),
  HAZARD_DETECTION_VECTOR("irobot_create_msgs", "HazardDetectionVector", 65_536),
  STRING("std_msgs", "String", 65_536),
  PATH("nav_msgs", "Path", 65_536),
  MARKER_ARRAY("visualization_msgs", "MarkerArray", 65_536);

  private final String family;
  private final String type;
  private final int mostBytes;

  RosType(String family, String type, int mostBytes) {
    this.family = family;
    this.type = type;
    this.mostBytes = mostBytes;
  }

  /** The type of that name, without its package. */
  static RosType of(String name) {
    for (RosType type : values()) {
      if (type.type.equals(name)) {
        return type;
      }
    }
    throw new IllegalArgumentException("no type " + name);
  }

  int mostBytes() {
    return mostBytes;
  }

  /** Its name in DDS. */
  String ddsName() {
    return family + "::msg::dds_::" + type + "_";
  }

  /** Its name without the package. */
  String shortName() {
    return type;
  }

  @Override
  public String toString() {
    return family + "/" + type;
  }
}
