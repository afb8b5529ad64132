package org.starl.robot.file;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The address of a listener.
 *
 * @param host a name or a numeric address, not looked up yet
 * @param port 1 to 65535
 */
public record HostPort(String host, int port) {

  static final int MAX_PORT = 65_535;

  private static final Pattern DIGITS = Pattern.compile("[1-9]\\d{0,4}");

  /**
   * Reads {@code HOST}, {@code HOST:PORT} or {@code [IPV6]:PORT}; null if the text is none of these.
   *
   * @param defaultPort for a text without a port; 0 if it must have one
   */
  static @Nullable HostPort parse(String text, int defaultPort) {
    int colon = text.lastIndexOf(':');
    boolean hasPort = colon >= 0 && (text.indexOf(':') == colon || text.charAt(colon - 1) == ']');
    String host = hasPort ? text.substring(0, colon) : text;
    if (host.startsWith("[") && host.endsWith("]")) {
      host = host.substring(1, host.length() - 1);
    }
    int port = defaultPort;
    if (hasPort) {
      String digits = text.substring(colon + 1);
      port = DIGITS.matcher(digits).matches() ? Integer.parseInt(digits) : 0;
    }
    boolean isValid = !host.isEmpty() && host.indexOf(' ') < 0 && port >= 1 && port <= MAX_PORT;
    return isValid ? new HostPort(host, port) : null;
  }

  /**
   * Looks the host up.
   *
   * @throws UnknownHostException if there is no such host
   */
  public InetSocketAddress resolve() throws UnknownHostException {
    return new InetSocketAddress(InetAddress.getByName(host), port);
  }

  @Override
  public String toString() {
    return (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + port;
  }
}
