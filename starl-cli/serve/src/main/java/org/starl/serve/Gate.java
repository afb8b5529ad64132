package org.starl.serve;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.cli.PageServer.Access;

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

  Gate(Access access) {
    this.access = access;
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
        || (needsToken() && ADDRESS.matcher(host).matches());
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
