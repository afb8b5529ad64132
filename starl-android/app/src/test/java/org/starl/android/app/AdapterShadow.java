package org.starl.android.app;

import android.bluetooth.BluetoothDevice;
import android.bluetooth.BluetoothSocket;
import java.io.IOException;
import java.util.UUID;
import java.util.function.Consumer;
import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;
import org.robolectric.annotation.RealObject;
import org.robolectric.shadow.api.Shadow;

/**
 * A paired serial adapter: each socket to it is a new one, as on a phone. It does not build on
 * Robolectric's own, which speaks of classes that Android 14 does not have.
 */
@Implements(BluetoothDevice.class)
public class AdapterShadow {

  static final String NAME = "RooTooth";

  /** Takes the other end of each socket to an adapter; throws what the connection shall fail with. */
  interface OtherEnd {
    void connected(String address, SocketShadow socket) throws IOException;
  }

  private static OtherEnd otherEnd = (address, socket) -> {};
  private static Consumer<UUID> services = service -> {};

  @RealObject private BluetoothDevice device;

  static void serve(OtherEnd newOtherEnd, Consumer<UUID> newServices) {
    otherEnd = newOtherEnd;
    services = newServices;
  }

  @Implementation
  protected String getName() {
    return NAME;
  }

  @Implementation
  protected BluetoothSocket createRfcommSocketToServiceRecord(UUID service) throws IOException {
    services.accept(service);
    BluetoothSocket socket = Shadow.newInstanceOf(BluetoothSocket.class);
    otherEnd.connected(device.getAddress(), Shadow.extract(socket));
    return socket;
  }
}
