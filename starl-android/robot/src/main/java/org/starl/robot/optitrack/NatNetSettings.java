package org.starl.robot.optitrack;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;

/**
 * The address of a NatNet server and the meaning of its stream. Immutable.
 *
 * @param server the server's command port
 * @param group the group that it streams to, with its data port; null for unicast
 * @param local the address of this machine's interface to use; null for any
 * @param axes convert its coordinates to StarL's
 * @param bounds assumptions on the server and the robots
 */
public record NatNetSettings(
    InetSocketAddress server,
    @Nullable InetSocketAddress group,
    @Nullable InetAddress local,
    Axes axes,
    FixBounds bounds) {

  public static final int COMMAND_PORT = 1510;
  public static final int DATA_PORT = 1511;

  /** Motive's default group. */
  public static final String GROUP = "239.255.42.99";

  public NatNetSettings {
    if (server.isUnresolved()) {
      throw new IllegalArgumentException("NatNet server " + server + ": no such host");
    }
    checkGroup(group);
  }

  /** A server that streams by unicast, with Motive's default ports. */
  public static NatNetSettings unicast(InetAddress server) {
    return new NatNetSettings(
        new InetSocketAddress(server, COMMAND_PORT), null, null, Axes.DEFAULT, FixBounds.DEFAULT);
  }

  /** A server that streams to a group, with Motive's defaults. */
  public static NatNetSettings multicast(InetAddress server) {
    return new NatNetSettings(
        new InetSocketAddress(server, COMMAND_PORT),
        new InetSocketAddress(GROUP, DATA_PORT),
        null,
        Axes.DEFAULT,
        FixBounds.DEFAULT);
  }

  static void checkGroup(@Nullable InetSocketAddress group) {
    if (group != null && (group.isUnresolved() || !group.getAddress().isMulticastAddress())) {
      throw new IllegalArgumentException(
          "NatNet group " + group + ": expected an address from 224.0.0.0 to 239.255.255.255");
    }
  }
}
