package org.starl.robot.file;

/**
 * A ROS 2 topic and the quality of service with which StarL opens it.
 *
 * @param key the part of the deployment file that describes it, for messages
 * @param name with its namespace, such as {@code /bot0/cmd_vel}
 * @param type the message's, without its package, such as {@code Twist}
 * @param isReliable RELIABLE, or else BEST_EFFORT
 * @param isTransientLocal TRANSIENT_LOCAL, or else VOLATILE
 */
public record RosTopic(
    String key, String name, String type, boolean isReliable, boolean isTransientLocal) {

  /** Stands in a name for the robot's. */
  public static final String ROBOT = "{robot}";

  /** The same of one robot. */
  public RosTopic of(String robot) {
    return new RosTopic(key, name.replace(ROBOT, robot), type, isReliable, isTransientLocal);
  }
}
