package org.starl.deployment;

import java.io.IOException;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.create.SocketLink;
import org.starl.deploy.file.Wheels.Device;
import org.starl.deploy.file.Wheels.Port;
import org.starl.deploy.file.Wheels.Tcp;
import org.starl.deploy.serial.PseudoTerminal;
import org.starl.deploy.serial.SerialLink;

/** How bytes get to a Create from a Linux board. */
public final class ByteLinks {

  private ByteLinks() {}

  /**
   * The driver's end.
   *
   * @param baud of a device
   */
  public static ByteLink.Source of(Port port, int baud) {
    return switch (port) {
      case Tcp tcp -> SocketLink.to(tcp.address().host(), tcp.address().port());
      case Device device -> SerialLink.at(device.path(), baud);
    };
  }

  /**
   * The far end, for a simulated Create: a pseudo terminal by that name.
   *
   * @throws IOException if there can be none
   */
  static ByteLink farEnd(Device device) throws IOException {
    return PseudoTerminal.open(device.path());
  }
}
