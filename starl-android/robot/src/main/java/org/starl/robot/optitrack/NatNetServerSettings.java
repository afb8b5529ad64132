package org.starl.robot.optitrack;

import java.net.InetSocketAddress;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Settings of a {@link NatNetServer}. Immutable.
 *
 * @param address where it listens for commands; port 0 for any free one
 * @param group to stream to, with its port; null to stream to each client
 * @param version 3.1, 4.0, 4.1 or 4.2
 * @param axes how our coordinates become the stream's
 * @param framesPerS from 1 to 1000
 */
public record NatNetServerSettings(
    InetSocketAddress address,
    @Nullable InetSocketAddress group,
    NatNetVersion version,
    Axes axes,
    int framesPerS) {

  /** The versions that a server can use. */
  public static final List<NatNetVersion> VERSIONS =
      List.of(NatNetVersion.V3_1, NatNetVersion.V4_0, NatNetVersion.V4_1, NatNetVersion.V4_2);

  private static final int MOST_FRAMES_PER_S = 1000;

  public NatNetServerSettings {
    NatNetSettings.checkGroup(group);
    if (!VERSIONS.contains(version)) {
      throw new IllegalArgumentException(
          "NatNet server of version " + version + ": expected one of " + VERSIONS);
    }
    if (framesPerS < 1 || framesPerS > MOST_FRAMES_PER_S) {
      throw new IllegalArgumentException(
          framesPerS + " frames a second: expected 1 to " + MOST_FRAMES_PER_S);
    }
  }
}
