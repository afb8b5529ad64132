package org.starl.robot;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
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

/** Opens the measuring system that a deployment's {@link Positions} describe. */
public final class PoseFeeds {

  private PoseFeeds() {}

  /** @param local this robot's address, to choose the interface by; null for any */
  static PoseFeed open(Positions positions, @Nullable InetAddress local, Clock clock, LogSink log)
      throws IOException {
    return switch (positions) {
      case Positions.NatNet natNet -> NatNetClient.open(settings(natNet, local), clock, log);
      case Positions.JsonFeed json -> JsonFeed.open(settings(json, local), clock, log);
    };
  }

  /** The axes of this deployment's NatNet stream. */
  public static Axes axes(Positions.NatNet natNet) {
    return new Axes(natNet.isYUp() ? UpAxis.Y : UpAxis.Z, BodyAxis.PLUS_X);
  }

  private static NatNetSettings settings(Positions.NatNet natNet, @Nullable InetAddress local)
      throws IOException {
    InetSocketAddress server = natNet.server().resolve();
    String multicast = natNet.multicast();
    InetSocketAddress group =
        multicast == null
            ? null
            : new InetSocketAddress(InetAddress.getByName(multicast), natNet.dataPort());
    return new NatNetSettings(server, group, local, axes(natNet), bounds(natNet));
  }

  private static JsonFeedSettings settings(Positions.JsonFeed json, @Nullable InetAddress local)
      throws IOException {
    InetSocketAddress here =
        local == null
            ? new InetSocketAddress(json.port())
            : new InetSocketAddress(local, json.port());
    String sender = json.sender();
    return new JsonFeedSettings(
        here, sender == null ? null : InetAddress.getByName(sender), bounds(json));
  }

  private static FixBounds bounds(Positions positions) {
    return FixBounds.DEFAULT.withErrors(positions.errorMm(), positions.errorRad());
  }
}
