package org.starl.robot.file;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.input.Form;

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
    boolean isValid = isHost(host) && port >= 1 && port <= MAX_PORT;
    return isValid ? new HostPort(host, port) : null;
  }

  /** Whether a text may be a host's name or its whole address. */
  private static boolean isHost(String host) {
    return host.matches(Form.HOST) || (host.indexOf(':') >= 0 && host.indexOf(' ') < 0);
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
