package org.starl.serve;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.cli.serve.PageServer.Access;

/**
 * Decides who may connect. A browser sends the name that it looked up as {@code Host}, and the page
 * that asks as {@code Origin}: so a page of another site, also one whose name was made to lead here
 * (DNS rebinding), is refused.
 */
final class Gate {

  private static final List<String> LOOPBACK = List.of("localhost", "127.0.0.1", "[::1]");
  private static final Pattern ADDRESS =
      Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}|\\[[0-9a-fA-F:.%]+\\]");
  private static final Pattern PORT = Pattern.compile(":\\d{1,5}$");

  private final Access access;
  private final String machine;

  /**
   * @param machine the name of this machine in its network; empty if it has none
   */
  Gate(Access access, String machine) {
    this.access = access;
    this.machine = machine;
  }

  /** The name of this machine; empty if it has none. */
  static String machine() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "";
    }
  }

  /** Why a request is refused, in one line; empty if it is not. The token is another matter. */
  String refusal(@Nullable String host, @Nullable String origin) {
    if (host == null || !isOwn(PORT.matcher(host).replaceFirst(""))) {
      return "Host: " + host + ": expected an address of this server";
    }
    if (origin != null && !origin.equals("http://" + host) && !access.origins().contains(origin)) {
      return "Origin: " + origin + ": expected http://" + host + ", or --origin " + origin;
    }
    return "";
  }

  /** Whether it is an address, or this machine's name: a site can lead any other name here. */
  private boolean isOwn(String host) {
    return LOOPBACK.contains(host)
        || host.equals(access.host())
        || (needsToken() && (ADDRESS.matcher(host).matches() || isMachine(host)));
  }

  /** Also by the name that neighbours find by multicast. */
  private boolean isMachine(String host) {
    return !machine.isEmpty()
        && (host.equalsIgnoreCase(machine) || host.equalsIgnoreCase(machine + ".local"));
  }

  /** Whether each request needs the token, because other machines can connect. */
  boolean needsToken() {
    return !access.token().isEmpty();
  }

  /** Whether this is the token; takes the same time for each that is not. */
  boolean isToken(@Nullable String given) {
    return given != null
        && MessageDigest.isEqual(
            given.getBytes(StandardCharsets.UTF_8),
            access.token().getBytes(StandardCharsets.UTF_8));
  }
}
