package org.starl.robot.optitrack;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;

/**
 * Where a {@link JsonFeed} listens. Immutable.
 *
 * @param address where to listen; port 0 for any free one
 * @param sender the only host whose lines are taken; null for every host
 * @param bounds assumptions on the measuring system and the robots
 */
public record JsonFeedSettings(
    InetSocketAddress address, @Nullable InetAddress sender, FixBounds bounds) {

  /** The default port. */
  public static final int PORT = 1520;

  /** Takes every host's lines at this address. */
  public static JsonFeedSettings at(InetAddress address) {
    return new JsonFeedSettings(new InetSocketAddress(address, PORT), null, FixBounds.DEFAULT);
  }

  public JsonFeedSettings withPort(int port) {
    return new JsonFeedSettings(new InetSocketAddress(address.getAddress(), port), sender, bounds);
  }

  public JsonFeedSettings withSender(@Nullable InetAddress newSender) {
    return new JsonFeedSettings(address, newSender, bounds);
  }

  public JsonFeedSettings withBounds(FixBounds newBounds) {
    return new JsonFeedSettings(address, sender, newBounds);
  }
}
