package org.starl.robot.file;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;

/**
 * Where something listens.
 *
 * @param host a name or a number, not looked up yet
 * @param port 1 to 65535
 */
public record HostPort(String host, int port) {

  static final int MAX_PORT = 65_535;

  /**
   * Looks the host up.
   *
   * @throws UnknownHostException if nobody is called so
   */
  public InetSocketAddress resolve() throws UnknownHostException {
    return new InetSocketAddress(InetAddress.getByName(host), port);
  }

  @Override
  public String toString() {
    return (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + port;
  }
}
