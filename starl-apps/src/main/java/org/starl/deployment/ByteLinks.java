package org.starl.deployment;

import java.io.IOException;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.create.SocketLink;
import org.starl.deploy.file.Wheels.Device;
import org.starl.deploy.file.Wheels.Port;
import org.starl.deploy.file.Wheels.Tcp;

/** How bytes get to a Create from a Linux board. */
public final class ByteLinks {

  private ByteLinks() {}

  /** @param baud of a device */
  public static ByteLink.Source of(Port port, int baud) {
    return switch (port) {
      case Tcp tcp -> SocketLink.to(tcp.address().host(), tcp.address().port());
      case Device device ->
          () -> {
            throw new IOException(device + " at " + baud + " baud");
          };
    };
  }
}
