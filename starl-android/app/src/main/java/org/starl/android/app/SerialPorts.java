package org.starl.android.app;

import android.content.Context;
import org.jspecify.annotations.Nullable;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.SocketLink;
import org.starl.robot.file.Wheels.Device;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.file.Wheels.Tcp;

/** The serial ports that a phone can open. */
final class SerialPorts {

  /** Prefix of a port over Bluetooth; the adapter's name or address follows. */
  static final String BLUETOOTH = "bluetooth:";

  private SerialPorts() {}

  static boolean canOpen(Port port) {
    return port instanceof Tcp || bluetooth(port) != null;
  }

  /** Links to the Create at a port that {@link #canOpen} accepts. */
  static ByteLink.Source at(Context context, Port port) {
    if (port instanceof Tcp tcp) {
      return SocketLink.to(tcp.address().host(), tcp.address().port());
    }
    String bluetooth = bluetooth(port);
    if (bluetooth == null) {
      throw new IllegalArgumentException("port " + port);
    }
    return new BluetoothLinks(context, bluetooth);
  }

  /** Name or address of the Create's Bluetooth adapter; null if the port is none. */
  private static @Nullable String bluetooth(Port port) {
    String path = port instanceof Device device ? device.path() : "";
    boolean hasName = path.startsWith(BLUETOOTH) && path.length() > BLUETOOTH.length();
    return hasName ? path.substring(BLUETOOTH.length()) : null;
  }
}
