package org.starl.robot;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.platform.Clock;
import org.starl.platform.DeploymentKey;
import org.starl.platform.LogSink;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Positions;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.BodyAxis;
import org.starl.robot.optitrack.FixBounds;
import org.starl.robot.optitrack.JsonFeed;
import org.starl.robot.optitrack.JsonFeedSettings;
import org.starl.robot.optitrack.NatNetClient;
import org.starl.robot.optitrack.NatNetSettings;
import org.starl.robot.optitrack.PoseFeed;
import org.starl.robot.optitrack.UpAxis;
import org.starl.time.Time;

/** Opens the measuring system that a {@link Deployment} describes. */
public final class PoseFeeds {

  private PoseFeeds() {}

  /**
   * @param linesKey of the JSON feed; null for none
   * @param local this robot's address, to choose the interface by; null for any
   */
  public static PoseFeed open(
      Deployment deployment,
      @Nullable DeploymentKey linesKey,
      @Nullable InetAddress local,
      Clock clock,
      LogSink log)
      throws IOException {
    FixBounds bounds = bounds(deployment);
    return switch (deployment.positions()) {
      case Positions.NatNet natNet ->
          NatNetClient.open(settings(deployment, natNet, bounds, local), clock, log);
      case Positions.JsonFeed json -> {
        String sender = json.sender();
        JsonFeedSettings settings =
            new JsonFeedSettings(
                linesAt(json, local),
                sender == null ? null : InetAddress.getByName(sender),
                linesKey,
                bounds);
        yield JsonFeed.open(settings, clock, log);
      }
      case Positions.Ros2 ros2 ->
          Ros2.of(deployment).poses(ros2, bodies(deployment), bounds, clock, log);
    };
  }

  private static List<String> bodies(Deployment deployment) {
    List<String> bodies = new ArrayList<>();
    deployment.robots().values().forEach(robot -> bodies.add(robot.rigidBody()));
    return bodies;
  }

  /** The axes of this deployment's NatNet stream. */
  public static Axes axes(Positions.NatNet natNet) {
    return new Axes(natNet.isYUp() ? UpAxis.Y : UpAxis.Z, BodyAxis.PLUS_X);
  }

  private static NatNetSettings settings(
      Deployment deployment, Positions.NatNet natNet, FixBounds bounds, @Nullable InetAddress local)
      throws IOException {
    InetSocketAddress server = natNet.server().resolve();
    String multicast = natNet.multicast();
    InetSocketAddress group =
        multicast == null
            ? null
            : new InetSocketAddress(InetAddress.getByName(multicast), natNet.dataPort());
    String at = natNet.networkInterface();
    InetAddress camerasAt =
        at == null
            ? NatNetClient.towards(server, local)
            : addressOf(deployment, at, server.getAddress());
    return new NatNetSettings(server, group, camerasAt, axes(natNet), bounds);
  }

  /**
   * This machine's address at the interface {@code positions.interface}, of the same kind as the server's.
   *
   * @throws BadInput if there is none
   */
  public static InetAddress addressOf(Deployment deployment, String at, InetAddress server)
      throws SocketException {
    List<String> names = new ArrayList<>();
    for (NetworkInterface each : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      names.add(each.getName());
      for (InetAddress address : Collections.list(each.getInetAddresses())) {
        boolean isMeant = each.getName().equals(at) || address.getHostAddress().equals(at);
        if (isMeant && address.getClass() == server.getClass()) {
          return address;
        }
      }
    }
    throw new BadInput(
        deployment.where("positions")
            + "positions.interface: "
            + BadInput.quote(at)
            + ": expected a network interface of this machine, by its name or address: one of "
            + names);
  }

  /**
   * The address at which a robot receives the lines of a JSON feed.
   *
   * @param local the robot's; null for any
   */
  public static InetSocketAddress linesAt(Positions.JsonFeed json, @Nullable InetAddress local)
      throws IOException {
    String listen = json.listen();
    return new InetSocketAddress(
        listen == null ? local : InetAddress.getByName(listen), json.port());
  }

  /** Assumptions from the deployment's errors and limits, with a check of jumps. */
  private static FixBounds bounds(Deployment deployment) {
    Positions positions = deployment.positions();
    Limits limits = deployment.limits();
    return FixBounds.DEFAULT
        .withErrors(positions.errorMm(), positions.errorRad())
        .withMotion(
            (1 + limits.speedError()) * limits.speedMmPerS(),
            limits.stillAfterNs() / Time.NS_PER_MS);
  }
}
