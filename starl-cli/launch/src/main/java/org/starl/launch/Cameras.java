package org.starl.launch;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.starl.platform.Clock;
import org.starl.robot.PoseFeeds;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.optitrack.JsonServer;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.NatNetServerSettings;
import org.starl.robot.optitrack.NatNetVersion;
import org.starl.robot.optitrack.PoseSource;

/** What stands in for the cameras of a deployment: a NatNet server or JSON lines, as its file says. */
public final class Cameras {

  private Cameras() {}

  /**
   * Streams {@code source} from now on, until the result is closed.
   *
   * @param framesPerS from 1 to 1000
   * @param clock of the times of {@code source}
   * @param onFailure receives, from any thread, an error that ends it early
   * @param console receives log lines, from any thread
   * @throws IOException if the address is not available
   */
  public static AutoCloseable open(
      Deployment deployment,
      PoseSource source,
      int framesPerS,
      Clock clock,
      Consumer<Throwable> onFailure,
      Consumer<String> console)
      throws IOException {
    return switch (deployment.positions()) {
      case Positions.NatNet natNet -> {
        NatNetServer server =
            NatNetServer.open(settings(natNet, framesPerS), source, clock, onFailure::accept);
        server.onRefusal(console);
        Set<InetAddress> hosts = new LinkedHashSet<>();
        addresses(deployment).forEach(robot -> hosts.add(robot.getAddress()));
        server.reserve(hosts);
        yield server;
      }
      case Positions.JsonFeed json -> {
        List<InetSocketAddress> robots = new ArrayList<>();
        for (InetSocketAddress robot : addresses(deployment)) {
          robots.add(PoseFeeds.linesAt(json, robot.getAddress()));
        }
        String sender = json.sender();
        yield JsonServer.open(
            new InetSocketAddress(sender == null ? null : InetAddress.getByName(sender), 0),
            robots,
            DeploymentFile.linesKey(deployment),
            source,
            clock,
            framesPerS,
            onFailure::accept);
      }
      case Positions.Ros2 ros2 ->
          throw new IllegalStateException(ros2 + ": topics of ROS 2 are not streamed");
    };
  }

  private static NatNetServerSettings settings(Positions.NatNet natNet, int framesPerS)
      throws IOException {
    String multicast = natNet.multicast();
    String[] version = natNet.version().split("\\.", -1);
    return new NatNetServerSettings(
        natNet.server().resolve(),
        multicast == null
            ? null
            : new InetSocketAddress(InetAddress.getByName(multicast), natNet.dataPort()),
        new NatNetVersion(Integer.parseInt(version[0]), Integer.parseInt(version[1])),
        PoseFeeds.axes(natNet),
        framesPerS);
  }

  /** The robots' addresses, of those that have one in the file. */
  private static List<InetSocketAddress> addresses(Deployment deployment) throws IOException {
    List<InetSocketAddress> known = new ArrayList<>();
    for (RobotEntry robot : deployment.robots().values()) {
      HostPort address = robot.address();
      if (address != null) {
        known.add(address.resolve());
      }
    }
    return known;
  }
}
