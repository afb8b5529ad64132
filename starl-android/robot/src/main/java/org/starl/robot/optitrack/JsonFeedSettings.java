package org.starl.robot.optitrack;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
import org.starl.platform.DeploymentKey;

/**
 * The address of a {@link JsonFeed} and the senders that it accepts. Immutable.
 *
 * @param address where it listens; port 0 for any free one
 * @param sender the only host whose lines are accepted; null for every host
 * @param key lines must be authenticated with it, and their times count from 1970; null for none
 * @param bounds assumptions on the measuring system and the robots
 */
public record JsonFeedSettings(
    InetSocketAddress address,
    @Nullable InetAddress sender,
    @Nullable DeploymentKey key,
    FixBounds bounds) {

  /** The default port. */
  public static final int PORT = 1520;
}
