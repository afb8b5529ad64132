package org.starl.robot.file;

import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** A robot's drive. */
public sealed interface Wheels {

  /**
   * An iRobot Create.
   *
   * @param model {@code create1} or {@code create2}
   * @param port carries its bytes
   * @param baud of a serial line, in bits a second
   * @param simulatedAt where the deployment's world simulates the other end; null for a real one
   */
  record Create(String model, Port port, int baud, @Nullable Port simulatedAt) implements Wheels {}

  /** A body in the deployment's world, whose process also runs the robot's program. */
  record Simulated() implements Wheels {}

  /**
   * A base that is a ROS 2 node.
   *
   * @param namespace of its topics, such as {@code /bot0}
   * @param axleMm distance between its wheels, for the limit of their speeds
   * @param command receives the speeds, a {@code Twist} or a {@code TwistStamped}
   * @param odometry a {@code nav_msgs/Odometry}
   * @param contacts its contacts; null: none are known
   * @param nearMm a laser's range below which something touches the body
   */
  record Ros2(
      String namespace,
      double axleMm,
      RosTopic command,
      RosTopic odometry,
      @Nullable RosTopic contacts,
      double nearMm)
      implements Wheels {}

  /** A link that carries the Create's bytes. */
  sealed interface Port {

    /** A phone's {@code bluetooth:1234} is none. */
    Pattern HOST_AND_PORT = Pattern.compile("((?!bluetooth:)[^\\s/:]+|\\[[^\\s/]+\\]):[0-9]+");

    /**
     * Reads a device's path or {@code tcp:HOST:PORT}; null if the address has no port, or {@code tcp:}
     * is missing: no device has the name {@code 127.0.0.1:4000}.
     */
    static @Nullable Port parse(String text) {
      if (!text.startsWith("tcp:")) {
        return HOST_AND_PORT.matcher(text).matches() ? null : new Device(text);
      }
      HostPort address = HostPort.parse(text.substring("tcp:".length()), 0);
      return address == null ? null : new Tcp(address);
    }
  }

  /** A serial device or a pseudo-terminal, by its path. */
  record Device(String path) implements Port {
    @Override
    public String toString() {
      return path;
    }
  }

  /** A TCP connection: the simulating process listens, the robot connects. */
  record Tcp(HostPort address) implements Port {
    @Override
    public String toString() {
      return "tcp:" + address;
    }
  }
}
