package org.starl.deployment;

import java.io.IOException;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.SocketLink;
import org.starl.robot.file.Wheels.Device;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.serial.PseudoTerminal;
import org.starl.robot.serial.SerialLink;

/** How bytes get to a Create from a Linux board. */
public final class ByteLinks {

  private static final String TCP = "tcp:";

  private ByteLinks() {}

  /**
   * The driver's end, with a process between that makes the Create stand when the driver's is gone.
   *
   * @param baud of a device
   */
  public static ByteLink.Source of(Port port, int baud) {
    return WheelGuard.source(port, baud);
  }

  /**
   * The same without anything between.
   *
   * @param port as {@link Port} writes it
   */
  static ByteLink.Source direct(String port, int baud) {
    if (!port.startsWith(TCP)) {
      return SerialLink.at(port, baud);
    }
    int colon = port.lastIndexOf(':');
    String host = port.substring(TCP.length(), colon).replace("[", "").replace("]", "");
    return SocketLink.to(host, Integer.parseInt(port.substring(colon + 1)));
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
