package org.starl.robot.optitrack;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How a {@link NatNetServer} streams. Immutable.
 *
 * @param address where it listens for commands; port 0 for any free one
 * @param group to stream to, with its port; null to stream to each client
 * @param version 3.1, 4.0, 4.1 or 4.2
 * @param axes how our coordinates become the stream's
 * @param framesPerS from 1 to 1000
 * @param hasMarkers whether the markers of each body are streamed too, as Motive does
 */
public record NatNetServerSettings(
    InetSocketAddress address,
    @Nullable InetSocketAddress group,
    NatNetVersion version,
    Axes axes,
    int framesPerS,
    boolean hasMarkers) {

  /** The versions that a server can speak. */
  public static final List<NatNetVersion> VERSIONS =
      List.of(NatNetVersion.V3_1, NatNetVersion.V4_0, NatNetVersion.V4_1, NatNetVersion.V4_2);

  private static final int MOST_FRAMES_PER_S = 1000;

  public NatNetServerSettings {
    NatNetSettings.checkGroup(group);
    if (!VERSIONS.contains(version)) {
      throw new IllegalArgumentException(
          "a server of NatNet " + version + ": expected one of " + VERSIONS);
    }
    if (framesPerS < 1 || framesPerS > MOST_FRAMES_PER_S) {
      throw new IllegalArgumentException(
          framesPerS + " frames a second: expected 1 to " + MOST_FRAMES_PER_S);
    }
  }

  /** A server of version 4.1 that streams 100 frames a second to each client. */
  public static NatNetServerSettings unicast(InetAddress address) {
    return new NatNetServerSettings(
        new InetSocketAddress(address, NatNetSettings.COMMAND_PORT),
        null,
        NatNetVersion.V4_1,
        Axes.DEFAULT,
        100,
        true);
  }

  /** The same, to a group. */
  public static NatNetServerSettings multicast(InetAddress address) {
    return unicast(address)
        .withGroup(new InetSocketAddress(NatNetSettings.GROUP, NatNetSettings.DATA_PORT));
  }

  public NatNetServerSettings withPort(int port) {
    return new NatNetServerSettings(
        new InetSocketAddress(address.getAddress(), port),
        group,
        version,
        axes,
        framesPerS,
        hasMarkers);
  }

  public NatNetServerSettings withGroup(@Nullable InetSocketAddress newGroup) {
    return new NatNetServerSettings(address, newGroup, version, axes, framesPerS, hasMarkers);
  }

  public NatNetServerSettings withVersion(NatNetVersion newVersion) {
    return new NatNetServerSettings(address, group, newVersion, axes, framesPerS, hasMarkers);
  }

  public NatNetServerSettings withAxes(Axes newAxes) {
    return new NatNetServerSettings(address, group, version, newAxes, framesPerS, hasMarkers);
  }

  public NatNetServerSettings withFramesPerS(int newFramesPerS) {
    return new NatNetServerSettings(address, group, version, axes, newFramesPerS, hasMarkers);
  }

  public NatNetServerSettings withMarkers(boolean newHasMarkers) {
    return new NatNetServerSettings(address, group, version, axes, framesPerS, newHasMarkers);
  }
}
